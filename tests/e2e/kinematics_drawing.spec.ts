import type { Page } from '@playwright/test';
import { defaultKinematics, type KinematicsSettings } from '../../web/src/app/kinematics.ts';
import { seriousViolations } from './support/axe.ts';
import { expect, open, test } from './support/page.ts';

test.use({ bypassCSP: true }); // for axe, see support/axe.ts

function lab(settings: Partial<KinematicsSettings> = {}, language: 'en' | 'zh' = 'en'): string {
  const kinematics = { ...defaultKinematics, points: 60, ...settings };
  return `#/kinematics?language="${language}"&kinematics=${JSON.stringify(kinematics)}`;
}

const controls = (page: Page) => page.locator('.drawing-controls');
const place = (page: Page) => page.locator('.drawing-place');
const errors = (page: Page) => page.locator('.drawing-errors-said');
const problem = (page: Page) => page.locator('#curve-problem');
const kind = (page: Page, name: string) => controls(page).getByRole('button', { name, exact: true });

async function expectInLink(page: Page, part: string): Promise<void> {
  await expect.poll(() => decodeURIComponent(page.url())).toContain(part);
}

/** The arm has come to the last target, and was never further than ε from one. */
async function expectDrawn(page: Page): Promise<void> {
  await expect(place(page)).toHaveText(/^target (\d+) of \1$/);
  await expect(errors(page)).toContainText(/; 0 of \d+ targets are further off than ε/);
}

test('letters that are typed are drawn to the end, nowhere further off than ε', async ({ page }) => {
  await open(page, lab());
  await kind(page, 'Letters').click();
  await expect(controls(page)).toHaveAttribute('data-curve', 'letters');
  await page.getByLabel('Text').fill('Hi!');
  await expect(place(page)).not.toContainText('of 61'); // the heart's: letters have ways between their strokes too
  await expectDrawn(page);
});

test('a typed formula is drawn; a broken one names its column, and the arm keeps the last good one', async ({
  page,
}) => {
  await open(page, lab());
  await kind(page, 'Formula').click();
  const y = page.getByLabel('y(t)');
  await y.fill('0.4 sin(2t) cos(t)');
  await expectDrawn(page);
  await expect(problem(page)).toBeEmpty();
  await expectInLink(page, '"y":"0.4 sin(2t) cos(t)"');

  await y.fill('0.4 sin(2t + cos(t)');
  await expect(problem(page)).toContainText('Column 8: this parenthesis is never closed. The arm keeps the last curve');
  await expect(y).toHaveAttribute('aria-invalid', 'true');
  await expect(y).toHaveAccessibleDescription(/^Column 8/);
  await expect(page.getByLabel('x(t)')).toHaveAttribute('aria-invalid', 'false');
  await expectDrawn(page);
  await expectInLink(page, '"y":"0.4 sin(2t) cos(t)"');

  await y.fill('1/(t - 1)');
  await expect(problem(page)).toContainText(/^At t = [\d.]+ this is −?[\d.]+ m: more than 100 m away/);
  await y.fill('0.4 sin(2t) cos(t)');
  await expect(problem(page)).toBeEmpty();
  await expect(y).toHaveAttribute('aria-invalid', 'false');
  await page.getByRole('button', { name: 'Rose' }).click();
  await expect(y).toHaveValue('0.7 cos(2t) sin(t)');
  await expectDrawn(page);
});

test('path data and pasted markup are drawn, and a mistake in them has its place', async ({ page }) => {
  await open(page, lab());
  await kind(page, 'SVG path').click();
  const data = page.getByLabel('Path data');
  await data.fill('<svg viewBox="0 0 9 9"><path d="M0 0h9v9z"/></svg>');
  await expect(problem(page)).toBeEmpty();
  await expectDrawn(page);
  await data.fill('M0 0 L5 5 ?');
  await expect(problem(page)).toContainText('Column 11: “?” cannot stand here in path data.');
  await expect(problem(page).locator('mark')).toHaveText('?');
});

test('drawing by hand takes the pen, any other curve puts it away', async ({ page }) => {
  await open(page, lab());
  const pen = page.getByRole('button', { name: 'Draw on the floor' });
  await kind(page, 'By hand').click();
  await expect(pen).toHaveAttribute('aria-pressed', 'true');
  await expect(kind(page, 'By hand')).toHaveAttribute('aria-pressed', 'true');
  await kind(page, 'Circle').click();
  await expect(pen).toHaveAttribute('aria-pressed', 'false');
  await expect(controls(page)).toHaveAttribute('data-curve', 'circle');
});

test('on a phone, the floor comes into sight with the pen', async ({ page }) => {
  await page.setViewportSize({ width: 390, height: 844 });
  await open(page, lab());
  await kind(page, 'By hand').click();
  await expect(page.locator('.arm-canvas')).toBeInViewport({ ratio: 0.99 });
});

test('while the arm draws, nobody is told of every search, and the slider stays where it is', async ({ page }) => {
  await page.setViewportSize({ width: 390, height: 844 });
  await open(page, lab({ curve: { kind: 'letters', text: 'Hello' }, points: 150 }));
  const moment = page.getByTestId('moment');
  const slider = page.getByRole('slider', { name: 'Target of the drawing' });
  await expect(page.getByRole('button', { name: 'Pause' })).toBeVisible();
  await expect(moment).toHaveAttribute('aria-live', 'off');
  const before = await slider.boundingBox();
  await expectDrawn(page);
  await expect(moment).toHaveAttribute('aria-live', 'polite');
  expect(await slider.boundingBox()).toEqual(before);
});

test('taking away the last link leaves the keyboard at the one before', async ({ page }) => {
  await open(page, lab());
  const remove = page.getByRole('button', { name: /^Remove the link/ });
  if (!(await remove.first().isVisible())) await page.getByText('Settings', { exact: true }).click();
  await expect(remove).toHaveCount(4);
  await remove.nth(3).press('Enter');
  await expect(remove).toHaveCount(3);
  await expect(remove.nth(2)).toBeFocused();
});

test('the three samplings are compared in numbers, and the arm takes the chosen one', async ({ page }) => {
  await open(page, lab({ curve: { kind: 'circle' }, points: 30 }));
  const cards = page.locator('.spread');
  await expect(cards).toHaveCount(3);
  // 30 points on a circle of radius 0.6 m, however they are spread: side 1.2 sin 6°, error 0.6 (1 − cos 6°).
  for (const card of await cards.all()) await expect(card.locator('dd')).toHaveText([/^0\.125.m$/, /^3\.29.mm$/]);
  await page.getByRole('radio', { name: 'Equal steps of t' }).check();
  await expect(page.locator('.even-sampling')).toHaveAttribute('data-sampling', 'parameter');
  await expectInLink(page, '"sampling":"parameter"');
  await page.getByLabel('Number of points', { exact: true }).last().fill('12');
  await page.keyboard.press('Enter');
  await expect(cards.first().locator('dd')).toHaveText([/^0\.311.m$/, /^20\.4.mm$/]);
  await expect(place(page)).toContainText('of 13');
});

test('everything is done with the keyboard', async ({ page }) => {
  await open(page, lab());
  await kind(page, 'Star').focus();
  await page.keyboard.press('Tab');
  await page.keyboard.press(' '); // Letters
  await expect(controls(page)).toHaveAttribute('data-curve', 'letters');
  for (let tab = 0; tab < 4; tab++) await page.keyboard.press('Tab'); // over Formula, By hand and SVG path
  await expect(page.getByLabel('Text')).toBeFocused();
  await page.keyboard.press('ControlOrMeta+a');
  await page.keyboard.type('r a'); // letters here, not the page's keys
  await expect(page.getByLabel('Text')).toHaveValue('r a');
  await page.keyboard.press('Enter');
  await expectDrawn(page);
  await page.getByRole('radio', { name: 'Equal arc lengths' }).focus();
  await page.keyboard.press('ArrowDown');
  await expect(page.getByRole('radio', { name: 'Closer where it bends' })).toBeChecked();
  await expectInLink(page, '"sampling":"curvature"');
});

for (const language of ['en', 'zh'] as const)
  test(`the controls keep nobody out and fit a phone, with and without a problem (${language})`, async ({ page }) => {
    await page.setViewportSize({ width: 390, height: 844 });
    await open(page, lab({ curve: { kind: 'formula', x: 't', y: 't²', from: '-1', to: '1' } }, language));
    expect(await seriousViolations(page)).toEqual([]);
    await page.locator('#curve-y').fill(`${'t + '.repeat(40)} foo`);
    await expect(problem(page)).toContainText('foo');
    expect(await seriousViolations(page)).toEqual([]);
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(390);
  });
