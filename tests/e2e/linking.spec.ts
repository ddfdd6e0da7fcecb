import type { Page } from '@playwright/test';
import { seriousViolations } from './support/axe.ts';
import { expect, open, test } from './support/page.ts';
import { countPixels } from './support/pixels.ts';

const lab = './#/springs?scene="net"&selection={"spring":12,"vertex":7}';

test.use({ bypassCSP: true }); // for axe

test.beforeEach(async ({ page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' });
});

/** The occurrences of a symbol in one place of the page, whose mark is a line below. */
const occurrences = (page: Page, place: string, id: string) => page.locator(`${place} [data-sym="${id}"]`);
const marked = /2px/;

async function openLab(page: Page): Promise<void> {
  await open(page, lab);
  await page.getByRole('button', { name: /^Half-step forward/ }).click();
  await expect(page.getByTestId('status')).toContainText('local');
}

test('a symbol in a formula is marked in the other formulas and in the code, and says what it is now', async ({
  page,
}) => {
  await openLab(page);
  await page.locator('.half-local .in-code summary').click();
  await page.locator('.half-local .symbol-legend').getByRole('button', { name: 'projected springs' }).focus();
  for (const place of ['.half-local .equation-formulas', '.half-global .equation-formulas', '.half-local .in-code'])
    await expect(occurrences(page, place, 'd').first()).toHaveCSS('box-shadow', marked);
  await expect(occurrences(page, '.half-local .equation-formulas', 'r').first()).not.toHaveCSS('box-shadow', marked);
  const card = page.getByRole('dialog', { name: 'projected springs' });
  for (const fact of ['#E × 3 = 120 × 3', 'Spring 12', 'Lesson, section 5']) await expect(card).toContainText(fact);
});

test('a line of code marks its symbols in the formulas, with the keyboard alone', async ({ page }) => {
  await openLab(page);
  await page.locator('.half-local .in-code summary').press('Enter');
  await page.keyboard.press('Tab');
  await expect(page.getByRole('button', { name: /^Line 1: / }).first()).toBeFocused();
  for (let line = 1; line < 8; line++) await page.keyboard.press('ArrowDown');
  await expect(page.getByRole('button', { name: 'Line 8: d.row(e) *= r(e) / length;' })).toBeFocused();
  for (const id of ['d', 'r'])
    await expect(occurrences(page, '.half-local .equation-formulas', id).first()).toHaveCSS('box-shadow', marked);
  await expect(occurrences(page, '.half-local .equation-formulas', 'p').first()).not.toHaveCSS('box-shadow', marked);
  await page.keyboard.press('ArrowRight'); // into the line, to its first symbol
  await expect(page.getByRole('dialog', { name: 'projected springs' })).toBeVisible();
  await expect(page.getByTestId('status')).toContainText('local'); // the cursor in time has not moved
});

test('the keyboard reaches the card’s link and comes back to where it was', async ({ page }) => {
  await openLab(page);
  const button = page.locator('.half-local .symbol-legend').getByRole('button', { name: 'rest length' });
  await button.focus();
  await page.keyboard.press('Enter');
  await expect(page.getByRole('link', { name: /^Lesson, section 1/ })).toBeFocused();
  await page.keyboard.press('Escape');
  await expect(button).toBeFocused();
  await expect(page.locator('.card')).toHaveCount(0);
  await page.keyboard.press('Shift+Tab');
  await page.keyboard.press('Enter');
  await page.keyboard.press('Tab');
  await expect(button).toBeFocused();
});

/** Of the glow around what is marked in 3D, #ffd60a, smoothed at its edges. */
const glowing = (page: Page, view: 'local' | 'global') =>
  countPixels(page.locator(`[data-view="${view}"]`), (r, g, b) => r > 220 && g > 180 && b < 120);

test('d in an equation makes the torn springs glow, p the vertices of the net', async ({ page }) => {
  await openLab(page);
  const before = { local: await glowing(page, 'local'), global: await glowing(page, 'global') };
  expect(before.local).toBeGreaterThan(0); // the selected spring and vertex
  await page.locator('.half-local .symbol-legend').getByRole('button', { name: 'projected springs' }).focus();
  // 120 springs instead of one: ten times is far from the one and from the other
  await expect.poll(() => glowing(page, 'local')).toBeGreaterThan(10 * before.local);
  expect(await glowing(page, 'global')).toBeLessThan(2 * before.global);
  await page.locator('.half-local .symbol-legend').getByRole('button', { name: 'positions' }).focus();
  // Unchanged it would be the same to the pixel; vertices glow less than the selected spring, the less the smaller the view.
  await expect.poll(() => glowing(page, 'global')).toBeGreaterThan(1.5 * before.global);
  await page.keyboard.press('Escape');
  await expect.poll(() => glowing(page, 'local')).toBe(before.local);
});

test('a spring under the mouse marks d in its equation, a vertex p, and none of them nothing', async ({ page }) => {
  await openLab(page);
  const lit = async () => (await page.locator('html').getAttribute('data-lit'))?.split(' ') ?? [];
  const view = await page.locator('[data-view="local"]').boundingBox();
  const sweep = async (id: string) => {
    const { x, y, width, height } = view as NonNullable<typeof view>;
    for (let down = 0; down < height; down += 2) {
      await page.mouse.move(x + 0.37 * width, y + down);
      if ((await lit()).includes(id)) return;
    }
    throw new Error(`nothing on the way marks ${id}`);
  };
  await sweep('d');
  await expect(occurrences(page, '.half-local .equation-formulas', 'd').first()).toHaveCSS('box-shadow', marked);
  expect(await lit()).not.toContain('p');
  await page.mouse.move(5, 5);
  await expect(occurrences(page, '.half-local .equation-formulas', 'd').first()).not.toHaveCSS('box-shadow', marked);
  const pin = await page.locator('.pin-handle').boundingBox();
  await page.mouse.move((pin?.x ?? 0) + 12, (pin?.y ?? 0) + 12);
  await expect(occurrences(page, '.half-global .equation-formulas', 'p').first()).toHaveCSS('box-shadow', marked);
  expect(await lit()).not.toContain('d');
});

/** Moves the mouse down through a view until it rests on something whose card is of this kind. */
async function restOn(page: Page, view: 'local' | 'global', kind: 'spring' | 'vertex') {
  const card = page.locator(`.card[data-kind="${kind}"]`);
  const { x, y, width, height } = await boxOf(page, `[data-view="${view}"]`);
  for (let down = 0; down < height; down += 2) {
    const place = { x: x + 0.37 * width, y: y + down };
    await page.mouse.move(place.x, place.y);
    if ((await card.count()) > 0) return { card, place };
  }
  throw new Error(`no ${kind} on the way`);
}

async function boxOf(page: Page, selector: string) {
  const box = await page.locator(selector).boundingBox();
  if (!box) throw new Error(`${selector} is not shown`);
  return box;
}

function contains(box: Box, { x, y }: { x: number; y: number }): boolean {
  return box.x < x && x < box.x + box.width && box.y < y && y < box.y + box.height;
}
type Box = Awaited<ReturnType<typeof boxOf>>;

test('a spring under the mouse in 3D opens its card beside it, a press closes it, a click makes it stay', async ({
  page,
}) => {
  await openLab(page);
  const { card, place } = await restOn(page, 'local', 'spring');
  await expect(card).toBeVisible();
  for (const fact of [/Spring \d+ ?from vertex \d+ to vertex \d+/, 'rest length', 'length now', 'Lesson, section 1'])
    await expect(card).toContainText(fact);
  expect(contains(await boxOf(page, '.card'), place)).toBe(false);
  await page.mouse.down();
  await expect(card).toHaveCount(0);
  await page.mouse.move(place.x + 40, place.y); // turns the camera
  await expect(card).toHaveCount(0);
  await page.mouse.up();

  const found = await restOn(page, 'local', 'spring');
  await page.mouse.click(found.place.x, found.place.y);
  await page.mouse.move(5, 5);
  await expect(found.card).toHaveAttribute('data-by', 'tap');
  await page.keyboard.press('Escape');
  await expect(found.card).toHaveCount(0);
});

test('no card opens in 3D while the clock runs, and an open one closes', async ({ page }) => {
  await openLab(page);
  const { card, place } = await restOn(page, 'global', 'vertex');
  await page.keyboard.press('a'); // plays
  await expect(card).toHaveCount(0);
  await page.mouse.move(place.x + 60, place.y);
  await page.mouse.move(place.x, place.y);
  await expect(page.locator('.card')).toHaveCount(0);
});

test('the inspector opens the card of the spring it names, for the keyboard, and follows its number', async ({
  page,
}) => {
  await openLab(page);
  await page.locator('.half-local .index-field input').focus();
  await expect(page.getByRole('dialog', { name: 'Spring 12' })).toBeVisible();
  await page.keyboard.press('ArrowUp');
  await expect(page.getByRole('dialog', { name: 'Spring 13' })).toBeVisible();
  await page.locator('.half-global .index-field input').focus();
  await expect(page.getByRole('dialog', { name: 'Vertex 7' })).toContainText('0.500');
  await page.keyboard.press('Escape');
  await expect(page.locator('.card')).toHaveCount(0);
});

test.describe('in the lesson', () => {
  /** A triangle of three springs and its A, with spring 1 selected. */
  async function openMatrices(page: Page) {
    await page.goto('./#/lesson/matrices');
    const figure = page.locator('figure').filter({ has: page.locator('.matrix-product') });
    await figure.scrollIntoViewIfNeeded(); // out of sight it sleeps
    await expect(figure.locator('.matrix')).toHaveCount(3);
    const litRows = () =>
      figure
        .locator('.matrix')
        .first()
        .locator('tbody tr')
        .evaluateAll((rows) => rows.flatMap((row, e) => (row.querySelector('th.lit') ? [e] : [])));
    return { figure, litRows };
  }

  test('d in an equation lights row e of A and the spring', async ({ page }) => {
    const { figure, litRows } = await openMatrices(page);
    await page.getByRole('button', { name: 'projected springs' }).first().focus();
    await expect.poll(litRows).toEqual([1]);
    await expect(figure.locator('svg [data-spring="1"]')).toHaveClass(/lit/);
  });

  test('a spring, a row of A and the equation light each other', async ({ page }) => {
    const { figure, litRows } = await openMatrices(page);
    const spring = (e: number) => figure.locator(`svg [data-spring="${e}"]`);
    const d = page.locator('main .formula [data-sym="d"]').first();
    await spring(2).focus();
    await expect.poll(litRows).toEqual([2]);
    await expect(d).toHaveCSS('box-shadow', marked);
    await figure.getByRole('button', { name: 'A, spring 0, vertex 0: 1' }).focus();
    await expect.poll(litRows).toEqual([0]);
    await expect(spring(0)).toHaveClass(/lit/);
    await expect(spring(2)).not.toHaveClass(/lit/);
    await page.keyboard.press('ArrowLeft');
    await expect(figure.getByRole('button', { name: 'spring 0', exact: true }).first()).toBeFocused();
    await page.keyboard.press('Escape');
    await expect.poll(litRows).toEqual([]);
  });

  test('the keyboard on a cell of A opens the card of the entry, from which the way leads back', async ({ page }) => {
    const { figure } = await openMatrices(page);
    const cell = figure.getByRole('button', { name: 'A, spring 0, vertex 1: −1' });
    await cell.focus();
    const card = page.getByRole('dialog', { name: 'A, spring 0, vertex 1' });
    for (const fact of ['spring 0 ends at vertex 1', 'from vertex 0 to vertex 1'])
      await expect(card).toContainText(fact);
    await page.keyboard.press('Enter');
    await expect(card.getByRole('link')).toBeFocused();
    await page.keyboard.press('Escape');
    await expect(cell).toBeFocused();
    await cell.focus();
    await page.keyboard.press('ArrowLeft');
    await page.keyboard.press('ArrowLeft');
    await expect(page.getByRole('dialog', { name: 'A, Spring 0' })).toContainText('row 0');
  });

  test('the cards of an entry and of a row’s head are clean for axe', async ({ page }) => {
    const { figure } = await openMatrices(page);
    const matrix = figure.locator('.matrix').first();
    for (const [cell, kind] of [
      ['td button', 'entry'],
      ['tbody th button', 'spring'],
    ]) {
      await matrix.locator(cell).first().focus();
      await expect(page.locator(`.card[data-kind="${kind}"]`)).toBeVisible();
      expect(await seriousViolations(page)).toEqual([]);
    }
  });

  test('a vertex of a picture opens its card, which a pull closes', async ({ page }) => {
    const { figure } = await openMatrices(page);
    const dot = figure.locator('svg [data-vertex="2"] .dot');
    await dot.hover();
    const card = page.getByRole('dialog', { name: 'Vertex 2' });
    await expect(card).toContainText('end of 2 springs');
    await page.mouse.down();
    const { x, y } = (await dot.boundingBox()) as Box;
    await page.mouse.move(x + 40, y + 30);
    await expect(card).toHaveCount(0);
    await page.mouse.up();
  });
});

for (const language of ['en', 'zh'])
  test(`the cards of a vertex and of a line of code are clean for axe: ${language}`, async ({ page }) => {
    await open(page, `${lab}&language="${language}"`);
    await page.locator('.half-global .index-field input').focus();
    await expect(page.locator('.card[data-kind="vertex"]')).toBeVisible();
    expect(await seriousViolations(page)).toEqual([]);
    await page.locator('.half-local .in-code summary').click();
    await page.locator('.half-local [data-line="local_step.cpp 8"] .code-line').focus();
    await expect(page.locator('.card[data-kind="line"]')).toContainText('local_step.cpp');
    expect(await seriousViolations(page)).toEqual([]);
  });

test('the card and the code are clean for axe, in both languages', async ({ page }) => {
  for (const [language, name] of [
    ['en', 'projected springs'],
    ['zh', '投影后的弹簧向量'],
  ]) {
    await open(page, `${lab}&language="${language}"`);
    await page.locator('.half-local .in-code summary').click();
    await page.locator('.half-local .symbol-legend button').first().focus();
    await expect(page.getByRole('dialog', { name })).toBeVisible();
    expect(await seriousViolations(page)).toEqual([]);
  }
});

test.describe('with a finger', () => {
  test.use({ hasTouch: true, viewport: { width: 390, height: 844 } });

  test('the card of what is tapped never leaves the window', async ({ page }) => {
    const isInside = ({ x, y, width, height }: Box) => x >= 0 && y >= 0 && x + width <= 390 && y + height <= 844;
    await openLab(page);
    const handle = await boxOf(page, '.pin-handle'); // at the edge of the net
    await page.touchscreen.tap(handle.x + 12, handle.y + 12);
    await expect(page.locator('.card[data-kind="vertex"]')).toContainText('pinned');
    expect(isInside(await boxOf(page, '.card'))).toBe(true);
    await page.goto('./#/lesson/matrices');
    const matrices = page.locator('.matrix-product .matrix');
    await expect(matrices).toHaveCount(3);
    for (const cell of await matrices.locator('td button, tbody th button').all()) {
      await cell.scrollIntoViewIfNeeded();
      await cell.tap();
      await expect(page.locator('.card')).toBeVisible();
      expect(isInside(await boxOf(page, '.card'))).toBe(true);
    }
  });

  test('a tap opens a card, a tap elsewhere closes it', async ({ page }) => {
    await openLab(page);
    await occurrences(page, '.half-local .equation-formulas', 'r').first().tap();
    await expect(page.getByRole('dialog', { name: 'rest length' })).toBeVisible();
    await page.locator('.half-local .symbol-legend button').last().tap();
    await expect(page.getByRole('dialog', { name: 'positions' })).toBeVisible();
    await page.locator('.caption').first().tap();
    await expect(page.locator('.card')).toHaveCount(0);
  });
});
