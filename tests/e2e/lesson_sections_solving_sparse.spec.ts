import type { Page } from '@playwright/test';
import { seriousViolations } from './support/axe.ts';
import { expect, openSection, test } from './support/page.ts';

test.use({ bypassCSP: true }); // for axe

/** The numbers of a row of a table, without units and spaces between groups. */
async function numbersIn(page: Page, row: string): Promise<number[]> {
  const cells = await page.locator(`${row} td`).allTextContents();
  return cells.map((text) => Number.parseFloat(text.replace(/\u202f(?=\d)/g, '')));
}

/** Has the figure's first moment solved. */
async function wakeFigure(page: Page): Promise<void> {
  const figure = page.locator('.figure').first();
  await figure.scrollIntoViewIfNeeded();
  await expect(figure).toHaveAttribute('data-ready', 'true');
}

/** Puts a slider of the page to its end. */
async function toTheEnd(page: Page, name: string): Promise<void> {
  const slider = page.getByRole('slider', { name });
  await slider.scrollIntoViewIfNeeded();
  await slider.focus();
  await page.keyboard.press('End');
}

test('substitution solves the moment shown, and a pull needs no new factor', async ({ page }) => {
  await openSection(page, 'solving');
  await wakeFigure(page);
  await toTheEnd(page, 'Rows solved');
  await expect(page.getByText(/no row of Q p differs from b by more than .*10⁻¹/)).toBeVisible();
  const pin = page.getByRole('button', { name: /Pin at vertex 0/ });
  await pin.focus();
  await page.keyboard.press('ArrowUp');
  await expect(page.getByText(/factorisations 1 .*, solves 2 /)).toBeVisible();
});

test('the clock fits an exponent to every way of solving and stops when told to', async ({ page }) => {
  await openSection(page, 'solving');
  await page.getByRole('button', { name: 'Start the clock' }).click();
  await page.getByRole('button', { name: 'Stop' }).click();
  await expect(page.getByText('Finished')).toBeHidden();

  await page.getByRole('button', { name: /Start the clock|Measure again/ }).click();
  await expect(page.getByText('Finished')).toBeVisible({ timeout: 50_000 });
  for (const call of ['dense_inverse', 'dense_factorise', 'dense_substitute', 'sparse_factorise', 'sparse_substitute'])
    await expect(page.locator(`[data-call="${call}"]`)).toContainText('points');
});

test('factors keep most zeros and the inverse none', async ({ page }) => {
  await openSection(page, 'solving');
  const answer = page.getByText('The answer').last();
  await answer.click();
  await expect(page.getByRole('img', { name: 'Q⁻¹: 3721 of 3721' })).toBeVisible();
  await expect(page.getByRole('img', { name: 'Q: 301 of 3721 entries are not zero' })).toBeVisible();
  expect(await seriousViolations(page)).toEqual([]);
});

test('overwritten triplets lead astray, and with stiff springs nowhere', async ({ page }) => {
  await openSection(page, 'sparse');
  await wakeFigure(page);
  await toTheEnd(page, 'Triplets inserted');
  const report = page.locator('.report');
  await expect(report).toContainText('up to 0 m');
  await page.getByLabel('overwrites (=)').click();
  await expect(report).toHaveText(/up to 0\.\d+\sm\./);
  await toTheEnd(page, 'stiffness of the springs');
  await expect(report).toContainText('No global step');
});

test('the counts are those of the scenes, and a good order fills less', async ({ page }) => {
  await openSection(page, 'sparse');
  await expect(page.locator('[data-scene="flag"]')).toContainText('0.21');
  // #V, #E, #V², #V + 2#E of flag.obj.
  expect((await numbersIn(page, '[data-scene="flag"]')).slice(0, 4)).toEqual([3321, 9720, 3321 ** 2, 3321 + 2 * 9720]);

  const filled = async () => Number(await page.locator('.fill-in').getAttribute('data-filled'));
  const natural = await filled();
  await page.getByLabel('fewest neighbours first').click();
  expect(await filled()).toBeLessThan(natural / 2);
  expect(await seriousViolations(page)).toEqual([]);
});

test('the flag is timed with its zeros left out and with all of them stored', async ({ page }) => {
  await openSection(page, 'sparse');
  await page.getByText('The answer').last().click();
  await page.getByRole('button', { name: 'Time one frame of the flag' }).click();
  for (const storage of ['sparse', 'dense'])
    await expect(page.locator(`[data-storage="${storage}"]`)).toContainText(/\d.*s.*\d.*s/, { timeout: 50_000 });
});
