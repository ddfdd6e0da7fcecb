import type { Page } from '@playwright/test';
import { expect, open, test } from './support/page.ts';

const status = (page: Page) => page.getByTestId('status');
const method = (page: Page) => page.getByRole('combobox', { name: 'Method' });
const ends = (page: Page) => page.getByRole('combobox', { name: 'A time step ends' });
const scrubber = (page: Page) => page.getByRole('slider', { name: 'Half-step of this time step' });

/** Opens the net and takes three time steps. */
async function openMoving(page: Page, parameters: object = { iterations: 6 }): Promise<void> {
  await page.emulateMedia({ reducedMotion: 'reduce' }); // then the page does not begin to play by itself
  await open(page, `./#/springs?scene="net"&parameters=${JSON.stringify(parameters)}`);
  for (const step of [1, 2, 3]) {
    await page.keyboard.press('Space');
    await expect(status(page)).toContainText(new RegExp(`t = ${step} · iteration (\\d+) of \\1 · accept`));
  }
}

/** J: E(p) at the end of the time step, once all of it has been traced by the method chosen. */
async function objectiveAtEnd(page: Page): Promise<number> {
  const shown = page.locator('.trace-readout').getByText('objective E(p)').locator('xpath=following-sibling::dd');
  await expect(page.locator('.trace-readout strong')).toContainText('accept');
  return Number((await shown.textContent())?.replace('−', '-').replace(/[^\d.-].*$/, ''));
}

test('every method lowers the objective further than local/global does in as many iterations', async ({ page }) => {
  // Stiff, so that no method is near the minimum; and past the ten plain iterations with which Chebyshev's begins.
  await openMoving(page, { iterations: 20, k: 30_000 });
  const plain = await objectiveAtEnd(page);
  for (const name of ['chebyshev', 'anderson', 'lbfgs', 'newton']) {
    await method(page).selectOption(name);
    await expect.poll(() => objectiveAtEnd(page), name).toBeLessThan(plain);
  }
});

test('a stopping rule ends the time step earlier, and words say why', async ({ page }) => {
  await openMoving(page);
  const iterations = page.getByTestId('iterations');
  await expect(iterations).toHaveText('6: all K');
  await ends(page).selectOption('stop_decrease');
  await page.getByRole('textbox', { name: 'tolerance ε' }).fill('0.05');
  await page.keyboard.press('Enter');
  await expect(iterations).toContainText(/^[1-5] of at most 6: E falls by no more than ε of itself/);
  const made = Number((await iterations.textContent())?.[0]);
  await expect(scrubber(page)).toHaveAttribute('max', `${2 * made + 1}`);
  await ends(page).selectOption('stop_gradient');
  await page.getByRole('textbox', { name: 'tolerance ε' }).fill('100');
  await page.keyboard.press('Enter');
  await expect(iterations).toContainText('the gradient of E is ≤ ε');
  await ends(page).selectOption('');
  await expect(scrubber(page)).toHaveAttribute('max', '13');
});

test('the link carries the method and the stopping rule', async ({ page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await open(page, './#/springs?scene="net"&parameters={"method":"lbfgs","stop_gradient":0.02}');
  await expect(method(page)).toHaveValue('lbfgs');
  await expect(page.getByRole('textbox', { name: 'tolerance ε' })).toHaveValue('0.02');
  await method(page).selectOption('anderson');
  await expect(page).toHaveURL(/"?anderson/);
});

test('the global panel says how another method goes on from Q p = b', async ({ page }) => {
  await openMoving(page, { method: 'anderson' });
  await expect(page.locator('.half-global .equation-note')).toContainText('Anderson mixes the solution');
});

test('shows the same time step by all methods, Newton’s when asked', async ({ page }) => {
  await openMoving(page);
  await page.getByRole('button', { name: 'Methods', exact: true }).click();
  const table = page.locator('.comparison-readout');
  const gap = (name: string) => table.getByRole('row', { name }).getByRole('cell').first();
  await expect(table.locator('caption')).toHaveText('After 6 iterations');
  for (const name of ['Local/global', 'Chebyshev', 'Anderson', 'L-BFGS'])
    await expect(gap(name)).toHaveText(/\d|rounding/);
  await gap('Newton').getByRole('button').click();
  await expect(gap('Newton')).toHaveText(/\d|rounding/);
  await expect(page.getByRole('img', { name: /^What 5 methods leave/ })).toBeVisible();
  await table.getByRole('button', { name: 'Chebyshev' }).click();
  await expect(page.getByRole('img', { name: /^What 4 methods leave/ })).toBeVisible();
  await page.getByRole('button', { name: 'ms', exact: true }).click();
  await expect(table.locator('caption')).toContainText('ms');
});

test('reads the comparison off with the keyboard alone', async ({ page }) => {
  await openMoving(page);
  await page.getByRole('button', { name: 'Methods', exact: true }).focus();
  await page.keyboard.press('Enter');
  const place = page.getByRole('slider', { name: 'Place to read off' });
  await place.focus();
  await page.keyboard.press('ArrowRight');
  await expect(page.locator('.comparison-readout caption')).toHaveText('After 7 iterations');
  await expect(place).toHaveAttribute('aria-valuetext', /After 7 iterations: E − E\*, J: .*L-BFGS/);
  await expect(status(page)).toContainText('accept'); // the arrows moved the reading, not the time
});

test('the comparison follows the time step, and waits while playing', async ({ page }) => {
  await openMoving(page);
  await page.getByRole('button', { name: 'Methods', exact: true }).click();
  const plot = page.getByRole('img', { name: /methods leave/ });
  await expect(plot).toHaveAccessibleName(/4 methods .* time step 3/);
  await page.keyboard.press('Space');
  await expect(plot).toHaveAccessibleName(/4 methods .* time step 4/);
  await page.getByRole('button', { name: 'Play' }).click();
  await expect(page.getByText('Playing: this is time step 4')).toBeVisible();
});

test('the panel says what an iteration, a time step and a picture cost', async ({ page }) => {
  await openMoving(page);
  const panel = page.locator('.solver-panel');
  await expect(panel).toContainText(/the parts of an iteration.*ms.*ms/);
  await expect(panel).toContainText(/a picture .*ms \/ 17.*ms \(60 Hz\)/);
  await page.getByRole('button', { name: 'Play' }).click();
  await expect(panel).toContainText(/a time step .*ms \/ 33.*ms \(Δt\)/);
  await expect(panel).toContainText(/6 × local: .*ms.*6 × global: .*ms/);
});
