import type { Page } from '@playwright/test';
import { seriousViolations } from './support/axe.ts';
import { expect, open, test } from './support/page.ts';
import { countPixels } from './support/pixels.ts';

const room = './#/springs/matrices?scene="net"&selection={"spring":12,"vertex":7}';

test.use({ bypassCSP: true }); // for axe

test.beforeEach(async ({ page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' });
});

const matrix = (page: Page) => page.getByRole('application');
const readout = (page: Page) => page.getByTestId('sparsity-readout');
const meant = (page: Page) => page.getByTestId('meant');
const tab = (page: Page, name: string) => page.getByRole('tab', { name });

/** Of the glow around what is marked in 3D, #ffd60a, smoothed at its edges. */
const glowing = (page: Page) =>
  countPixels(page.locator('.net-picture-view'), (r, g, b) => r > 220 && g > 180 && b < 120);

for (const [language, name, tabName, facts] of [
  ['en', 'Matrices', 'All matrices', '120 × 61'],
  ['zh', '矩阵', '全部矩阵', '120 × 61'],
] as const)
  test(`opens from the lab’s bar, clean for axe at every station: ${language}`, async ({ page }) => {
    await open(page, `./#/springs?scene="net"&language="${language}"`);
    await page.locator('.room-links').getByRole('link', { name, exact: true }).click();
    await expect(page.getByRole('tab', { selected: true })).toHaveText(tabName);
    await expect(page.getByText(facts)).toBeVisible();
    for (let station = 0; station < 6; station++) {
      await page.getByRole('tab').nth(station).click();
      await expect(page.getByText('…', { exact: true })).toHaveCount(0); // everything is measured
      expect(await seriousViolations(page)).toEqual([]);
    }
  });

test('row e of A lights spring e, and the selected spring its row; with the keyboard alone', async ({ page }) => {
  await open(page, room);
  await expect(meant(page)).toContainText('spring 12: vertex 7 to vertex 0');
  await matrix(page).focus();
  await expect(readout(page)).toContainText('row 0 (spring 0), column 0 (vertex 0): +1');
  await expect(meant(page)).toContainText('spring 0');
  const before = await glowing(page);
  for (let row = 0; row < 3; row++) await page.keyboard.press('PageDown');
  await expect(readout(page)).toContainText('row 3 (spring 3)');
  await expect(meant(page)).toContainText('spring 3');
  await page.keyboard.press('ArrowRight'); // over the zeros
  await expect(readout(page)).toContainText('column 3 (vertex 3): −1');
  await page.keyboard.press('Shift+ArrowRight');
  await expect(readout(page)).toContainText('column 4 (vertex 4): 0');
  await page.keyboard.press('ArrowLeft');
  await page.keyboard.press('Enter');
  await page.keyboard.press('Escape');
  await expect(meant(page)).toContainText('spring 3');
  await expect(page).toHaveURL(/selection=\{%22spring%22:3,%22vertex%22:3\}/);
  expect(before).toBeGreaterThan(0);
  expect(await glowing(page)).toBeGreaterThan(0);
  await expect(page.getByTestId('status')).toContainText('predict'); // the cursor in time has not moved
});

test('a spring under the mouse in the picture is marked in the matrix, an entry under the mouse in the picture', async ({
  page,
}) => {
  await open(page, room);
  const accent = () => countPixels(matrix(page), (r, g, b) => r < 40 && g > 70 && g < 120 && b > 160); // #0b5fbf
  await expect.poll(accent).toBeGreaterThan(10); // the selected row and column
  const view = await page.locator('.net-picture-view').boundingBox();
  const { x, y, width, height } = view as NonNullable<typeof view>;
  const first = await meant(page).textContent();
  for (let down = 0.3 * height; down < height; down += 2) {
    await page.mouse.move(x + 0.37 * width, y + down);
    if ((await meant(page).textContent()) !== first) break;
  }
  await expect(meant(page)).not.toHaveText(first as string);
  await expect.poll(accent).toBeGreaterThan(10);
  const box = await matrix(page).boundingBox();
  const place = box as NonNullable<typeof box>;
  const entry = /row \d+ \(spring \d+\), column \d+ \(vertex \d+\)/;
  // Most of a row is zeros, of which nothing is said from so far away.
  for (let across = 0.3 * place.width; across < 0.7 * place.width; across += 2) {
    await page.mouse.move(place.x + across, place.y + place.height / 2);
    if (entry.test((await readout(page).textContent()) ?? '')) break;
  }
  await expect(readout(page)).toContainText(entry);
  const spring = /spring (\d+)/.exec((await readout(page).textContent()) ?? '')?.[1];
  await expect(meant(page)).toContainText(`spring ${spring}:`);
});

test('ctrl and wheel zoom about the pointer, the wheel alone scrolls the page, 0 shows all again', async ({ page }) => {
  await open(page, room);
  const box = await matrix(page).boundingBox();
  const { x, y, width, height } = box as NonNullable<typeof box>;
  await page.mouse.move(x + width / 2, y + height / 3);
  const whole = await matrix(page).screenshot();
  await page.keyboard.down('Control');
  for (let notch = 0; notch < 12; notch++) await page.mouse.wheel(0, -100);
  await page.keyboard.up('Control');
  await expect.poll(() => matrix(page).screenshot()).not.toEqual(whole);
  await matrix(page).focus();
  await page.keyboard.press('0');
  await page.keyboard.press('+');
  await page.keyboard.press('-');
  await expect(readout(page)).toContainText('row 0');
});

test('Q is built up by its terms, and b by the springs of a vertex', async ({ page }) => {
  await open(page, room);
  await page.getByRole('button', { name: /^Half-step forward/ }).click();
  await tab(page, 'Q and b').click();
  await page.getByRole('button', { name: /springs$/ }).click();
  await matrix(page).focus();
  await expect(readout(page)).toContainText('from masses');
  await expect(readout(page)).not.toContainText('springs');
  await expect(page.locator('.term-toggle.lit')).toHaveText(/masses/);
  const sum = page.locator('.assembly tfoot tr').first().locator('td');
  const b = page.locator('.assembly tfoot tr').last().locator('td');
  await expect(page.getByText('The sum is b.')).toBeVisible();
  expect(await sum.allTextContents()).toEqual(await b.allTextContents());
  await page.locator('.right-hand-side').getByRole('button', { name: 'To the beginning' }).click();
  const y = page.locator('.assembly tbody tr').first().locator('td');
  expect(await sum.allTextContents()).toEqual(await y.allTextContents());
});

test('elimination goes forwards and back, and back is where it began', async ({ page }) => {
  await open(page, room);
  await tab(page, 'Elimination').click();
  const says = page.getByTestId('elimination');
  const stepper = page.locator('.elimination-matrix');
  const canvas = matrix(page).locator('canvas');
  await expect(says).toContainText('Nothing is eliminated yet');
  await expect(page.locator('[data-ordering="natural"] td').first()).toHaveText('459');
  await page.getByRole('radio', { name: 'minimum degree' }).check();
  await expect(matrix(page)).toHaveAccessibleName(/0 of 55/);
  const on = stepper.getByRole('button', { name: 'One step on' });
  const back = stepper.getByRole('button', { name: 'One step back' });
  const picture = () => canvas.evaluate((element: HTMLCanvasElement) => element.toDataURL());
  const selected = await meant(page).textContent();
  await on.click();
  await expect(says).toContainText('Column 0 ');
  await expect(meant(page)).not.toHaveText(selected as string); // the vertex just eliminated
  await back.click(); // which stays selected
  await expect(says).toContainText('Nothing is eliminated yet');
  await expect.poll(picture).not.toBe('');
  const begin = await picture();
  await stepper.getByRole('slider').fill('55');
  await expect(says).toContainText('this is L. Fill-in: 172');
  await expect.poll(picture).not.toBe(begin);
  await stepper.getByRole('slider').fill('1');
  await expect(says).toContainText('Column 0 ');
  await back.click();
  await expect(says).toContainText('Nothing is eliminated yet');
  await expect.poll(picture).toBe(begin);
  await expect(page.getByTestId('tree')).toContainText('55 columns');
});

test('the ledger: guess, try on a second solver, and the reader’s own simulation stays as it is', async ({ page }) => {
  await open(page, room);
  await tab(page, 'When to factorise').click();
  const own = await page.getByTestId('own-factorisations').textContent();
  const row = (name: string) => page.locator(`[data-trial="${name}"]`);
  await expect(row('k').getByRole('button')).toBeDisabled();
  const truths = {
    k: true,
    mass: true,
    delta_t: true,
    w: true,
    pins: true,
    positions: false,
    gravity: false,
    target: false,
  };
  for (const [name, again] of Object.entries(truths)) {
    await row(name).getByRole('radio', { name: 'yes' }).check();
    await row(name).getByRole('button').click();
    await expect(row(name).locator('.truth')).toContainText(again ? 'yes, again.' : 'no, kept.');
    await expect(row(name).locator('.truth')).toHaveAttribute('data-right', String(again));
  }
  await expect(page.getByText('5 of 8 guessed right')).toBeVisible();
  await expect(page.getByTestId('own-factorisations')).toHaveText(own as string);
  await tab(page, 'All matrices').click();
  await tab(page, 'When to factorise').click();
  await expect(row('k').getByRole('radio', { name: 'yes' })).toBeChecked();
});

test('dense against sparse is measured here', async ({ page }) => {
  await open(page, room);
  await tab(page, 'Dense or sparse').click();
  await expect(page.locator('[data-cost="bytesOfQ"] td').first()).toHaveText('24.2\u202fkB'); // 55² doubles
  await expect(page.locator('[data-cost="substitute"] td').nth(1)).toHaveText(/µs|ms/);
  await expect(page.getByText('unknowns one dense factorisation takes longer than a second')).toBeVisible();
});

test('K is added up spring by spring, with the masses, and without the pinned vertices', async ({ page }) => {
  await open(page, room);
  await tab(page, 'Linearly implicit').click();
  const stage = (name: string) => page.locator('.implicit-stages').getByRole('button', { name });
  const stepper = page.locator('.implicit-matrix');
  const places = page.getByTestId('spring-places');
  await expect(matrix(page)).toHaveAccessibleName('K with 1 of 120 springs');
  await stepper.getByRole('button', { name: 'To the beginning' }).click();
  await expect(page.getByText('No spring is added yet. Step on.')).toBeVisible();
  for (let spring = 0; spring < 3; spring++) {
    await stepper.getByRole('button', { name: 'One step on' }).click();
    await expect(meant(page)).toContainText(`spring ${spring}:`); // which is marked in the net, too
  }
  await expect(places).toContainText('goes to (0, 0) and (2, 2)');
  await matrix(page).focus();
  await expect(readout(page)).toContainText(/row 0 \(vertex 0, x\), column 0 \(vertex 0, x\): −.*N\/m/);
  await stage('with masses').click();
  await expect(matrix(page)).toHaveAccessibleName('M − Δt²K with 3 of 120 springs');
  await matrix(page).focus();
  await expect(readout(page)).toContainText(/\+.*kg/);

  // Spring 119 ends at the pinned vertex 49.
  await stepper.getByRole('slider').fill('120');
  await expect(places).toContainText('(60, 60) and (49, 49)');
  await stage('free vertices only').click();
  await expect(places).toHaveText('Vertex 49 is pinned: only the block at (60, 60) is left.');
  await expect(page.getByTestId('beside-q')).toContainText('301');
  await expect(page.getByTestId('beside-q')).toContainText('9 times as many');
  await page.getByRole('link', { name: 'other integrators' }).click();
  await expect(page).toHaveURL(/#\/integrators/);
});

test('a compressed spring says that its block is indefinite', async ({ page }) => {
  await open(page, room);
  await page.getByRole('button', { name: /^One time step/ }).click();
  await tab(page, 'Linearly implicit').click();
  const definite = page.getByTestId('spring-definite');
  const slider = page.locator('.implicit-matrix').getByRole('slider');
  await slider.fill('2');
  await expect(definite).toContainText('Not compressed');
  await slider.fill('3'); // spring 2 is one of the thirty that the first time step shortens
  await expect(definite).toContainText(/1 − r\/l = −.* indefinite/);
});

test('the tabs are one tab stop, with arrow keys inside', async ({ page }) => {
  await open(page, room);
  await tab(page, 'All matrices').focus();
  await page.keyboard.press('ArrowRight');
  await expect(tab(page, 'Q and b')).toBeFocused();
  await expect(page.getByRole('tabpanel')).toHaveAccessibleName(/^Q and b/);
  await page.keyboard.press('End');
  await expect(tab(page, 'Linearly implicit')).toBeFocused();
  await page.keyboard.press('Home');
  await expect(tab(page, 'All matrices')).toHaveAttribute('aria-selected', 'true');
});

test('on a phone nothing is to be scrolled sideways, and the net stays in sight', async ({ page }) => {
  await page.setViewportSize({ width: 390, height: 844 });
  await open(page, room);
  for (let station = 0; station < 6; station++) {
    await page.getByRole('tab').nth(station).click();
    await expect(page.getByText('…', { exact: true })).toHaveCount(0);
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(390);
  }
  await page.getByRole('tab').first().click();
  await matrix(page).scrollIntoViewIfNeeded();
  await expect(page.locator('.net-picture-view')).toBeInViewport();
});

test('on a phone, coming from the mistakes, the net leaves the tabs below it free', async ({ page }) => {
  await page.setViewportSize({ width: 390, height: 844 });
  await open(page, './#/springs/misconceptions?scene="net"');
  await page.locator('.room-links').getByRole('link', { name: 'Matrices' }).click();
  await tab(page, 'Q and b, term by term').click();
  await expect(tab(page, 'Q and b, term by term')).toHaveAttribute('aria-selected', 'true');
});

test('the lesson leads to the room', async ({ page }) => {
  await page.goto('./#/lesson/matrices');
  await page.getByRole('link', { name: /matrix room/ }).click();
  await expect(page.getByRole('tab', { name: 'All matrices' })).toBeVisible();
});
