import { readFile } from 'node:fs/promises';
import type { Page } from '@playwright/test';
import { seriousViolations } from './support/axe.ts';
import { expect, test } from './support/page.ts';

const status = (page: Page) => page.getByTestId('status');
const sentence = (page: Page) => page.locator('.gap-closed');
const stops = (page: Page) => page.locator('.comparison-stops');
const steps = (page: Page) => page.getByRole('slider', { name: 'Time step', exact: true });
const halfSteps = (page: Page) => page.getByRole('slider', { name: 'Half-step of this time step' });

/** Opens the room on the net at rest, paused. */
async function openRoom(page: Page, language = 'en'): Promise<void> {
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await page.goto(`./#/springs/convergence?scene="net"&language="${language}"`);
  await expectCompared(page);
}

/** Every method has been heard on this time step. */
async function expectCompared(page: Page): Promise<void> {
  await expect(sentence(page)).toHaveAttribute('data-complete', 'true');
}

async function tryNet(page: Page): Promise<void> {
  await page.getByRole('button', { name: 'Try the net' }).click();
  await expect(status(page)).toContainText('t = 10 · iteration 50 of 50 · accept');
  await expectCompared(page);
}

test('fifty iterations close all of the net’s gap, and little of the stiff flag’s', async ({ page }) => {
  await openRoom(page);
  await tryNet(page);
  await expect(sentence(page)).toContainText(/50 iterations .* close all/);
  await expect(sentence(page)).toContainText('= 8.0');
  await page.getByRole('button', { name: 'Try the stiff flag' }).click();
  await expect(page.getByRole('textbox', { name: 'k stiffness of the springs' })).toHaveValue('100000');
  await expect(status(page)).toContainText('t = 10');
  await expectCompared(page);
  await expect(sentence(page)).toContainText(/50 iterations .* close \d(\.\d)? %/);
  await expect(sentence(page)).toContainText('2.0 × 10⁶');
});

test('the curves show gap or gradient, against iterations or time, each on or off, and as CSV', async ({ page }) => {
  await openRoom(page);
  await expect(page.getByRole('img', { name: /^What 5 methods leave of E − E\*/ })).toBeVisible();
  await page.getByRole('button', { name: 'gradient of E', exact: true }).click();
  await expect(page.getByRole('img', { name: /^What 5 methods leave of the gradient/ })).toBeVisible();
  await page.getByRole('button', { name: 'ms', exact: true }).click();
  await expect(page.locator('.comparison-readout caption')).toContainText('ms');
  await page.locator('.comparison-readout').getByRole('button', { name: 'Newton' }).click();
  await expect(page.getByRole('img', { name: /^What 4 methods leave of the gradient/ })).toBeVisible();
  await page.getByText('Table of all iterations').click();
  const download = page.waitForEvent('download');
  await page.getByRole('button', { name: 'Download CSV' }).click();
  const csv = await readFile(await (await download).path(), 'utf8');
  expect(csv).toMatch(/^method,iteration,milliseconds,change,gradient\nlbfgs,0,0,0,/);
  expect(csv).toContain('\nnewton,1,');
});

test('says where a stopping rule ends each method, and the solver ends there', async ({ page }) => {
  await openRoom(page);
  await tryNet(page);
  const made = (name: string) => stops(page).getByRole('row', { name }).getByRole('cell').first();
  for (const name of ['Local/global', 'Chebyshev']) await expect(made(name)).toHaveText('50');
  await page.getByRole('combobox', { name: 'A time step ends' }).selectOption('stop_gradient');
  await expect(stops(page).locator('caption')).toContainText('once the gradient of E is ≤ 0.001');
  await expect(stops(page).getByRole('row', { name: 'Local/global' })).toContainText('gradient ≤ ε');
  for (const [value, name] of [
    ['local-global', 'Local/global'],
    ['newton', 'Newton'],
  ] as const) {
    await page.getByRole('combobox', { name: 'Method' }).selectOption(value);
    await halfSteps(page).fill('0');
    const iterations = await made(name).textContent();
    await expect(halfSteps(page)).toHaveAttribute('max', `${2 * Number(iterations) + 1}`);
  }
});

test('both lines of time are scrubbed with the keyboard', async ({ page }) => {
  await openRoom(page);
  await tryNet(page);
  await steps(page).focus();
  for (const press of ['ArrowLeft', 'ArrowLeft', 'ArrowLeft']) await page.keyboard.press(press);
  await expect(status(page)).toContainText('t = 7 · iteration 50 of 50 · accept');
  await expect(steps(page)).toHaveAttribute('aria-valuetext', 'time step t = 7, of those from 1 to 10');
  await halfSteps(page).focus();
  await page.keyboard.press('Home');
  await expect(status(page)).toContainText('t = 7 · iteration 0 of 50 · predict');
  await page.keyboard.press('ArrowRight');
  await expect(status(page)).toContainText('t = 7 · iteration 1 of 50 · local');
  await expect(page.locator('.convergence-levels dl .local')).toHaveAttribute('data-made', 'true');
  await steps(page).focus();
  await page.keyboard.press('End');
  await expect(status(page)).toContainText('t = 10 · iteration 50 of 50 · accept');
  await page.keyboard.press('Home');
  await expect(status(page)).toContainText('t = 1 ·');
});

test('few and many iterations run side by side', async ({ page }) => {
  await openRoom(page);
  await page.getByRole('button', { name: 'Let them go, with 1, 10 and 50 iterations' }).click();
  for (const K of [1, 10, 50]) await expect(page.getByRole('heading', { name: `K = ${K}`, exact: true })).toBeVisible();
  await expect(page.getByRole('img', { name: /^The total energy over time/ })).toBeVisible();
});

test('the lesson leads to the room and back', async ({ page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await page.goto('./#/lesson/trick');
  await page.getByRole('link', { name: 'each rule stops each method' }).click();
  await expectCompared(page);
  await page.getByRole('link', { name: 'why', exact: true }).click();
  await page.getByRole('link', { name: 'other methods come on a whole net' }).click();
  await expectCompared(page);
});

for (const [language, viewport] of [
  ['en', { width: 1280, height: 720 }],
  ['zh', { width: 390, height: 844 }],
] as const)
  test(`axe finds nothing serious, and nothing is too wide: ${language}, ${viewport.width}×${viewport.height}`, async ({
    browser,
    baseURL,
  }) => {
    const context = await browser.newContext({ bypassCSP: true, viewport, baseURL: baseURL as string });
    const page = await context.newPage();
    await openRoom(page, language);
    expect(await seriousViolations(page)).toEqual([]);
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(viewport.width);
    await context.close();
  });
