import type { Page } from '@playwright/test';
import { en } from '../../web/src/app/messages/en/index.ts';
import { zh } from '../../web/src/app/messages/zh/index.ts';
import { sectionIds } from '../../web/src/notation/sections.ts';
import { seriousViolations } from './support/axe.ts';
import { expect, open, openSection, test } from './support/page.ts';

test.use({ bypassCSP: true }); // for axe

test.beforeEach(async ({ page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' });
});

const lesson = (rest: string) => `./#/lesson/${rest}`;
const firstFigure = (page: Page) => page.locator('.figure').first();
/** Where the figure's clock and cursor stand, in words. */
const place = (page: Page) => firstFigure(page).locator('.figure-place');

async function openTrick(page: Page): Promise<void> {
  await openSection(page, 'trick');
  await firstFigure(page).locator('.figure-transport').scrollIntoViewIfNeeded();
  await expect(place(page)).toHaveText('t = 10 · iteration 1 of 4 · local');
}

for (const [language, messages] of Object.entries({ en, zh }))
  for (const id of sectionIds)
    test(`the section opens by its link, its figure ready and accessible: ${id}, ${language}`, async ({ page }) => {
      await openSection(page, id, `?language="${language}"`);
      await expect(page.getByRole('heading', { level: 2 })).toHaveText(messages.symbols.section[id]);
      await expect(page).toHaveTitle(`${messages.symbols.section[id]} – ${messages.page.title}`);
      await firstFigure(page).scrollIntoViewIfNeeded();
      await expect(firstFigure(page)).toHaveAttribute('data-ready', 'true');
      expect(await seriousViolations(page)).toEqual([]);
    });

test('a figure walks by half-steps, over the edge of a time step and back, and resets', async ({ page }) => {
  await openTrick(page);
  const button = (name: string) => firstFigure(page).getByRole('button', { name, exact: true });
  await button('Half-step forward').click();
  await expect(place(page)).toHaveText('t = 10 · iteration 1 of 4 · global');
  for (const [move, reached] of [
    ['One time step', 't = 10 · iteration 4 of 4 · accept'],
    ['Half-step forward', 't = 11 · iteration 0 of 4 · predict'],
    ['Half-step back', 't = 10 · iteration 4 of 4 · accept'],
    ['Reset to rest', 't = 10 · iteration 1 of 4 · local'],
  ]) {
    await button(move).click();
    await expect(place(page)).toHaveText(reached);
  }
});

test('a vertex follows the mouse while time runs, and is free again afterwards', async ({ page }) => {
  await openTrick(page);
  const dot = firstFigure(page).locator('.vertex[data-vertex="7"] .dot');
  await dot.scrollIntoViewIfNeeded();
  const middle = async () => {
    const { x, y, width, height } = (await dot.boundingBox()) as {
      x: number;
      y: number;
      width: number;
      height: number;
    };
    return { x: x + width / 2, y: y + height / 2 };
  };
  const { x, y } = await middle();
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 80, y - 40, { steps: 4 });
  await expect(place(page)).toContainText('accept'); // steps are being made
  await expect(firstFigure(page).locator('.pin')).toHaveCount(3);
  await expect.poll(async () => Math.round((await middle()).x - x)).toBe(80); // it is where the pointer is
  await page.mouse.up();
  await expect(firstFigure(page).locator('.pin')).toHaveCount(2);
});

test('everything in a figure can be done with the keyboard alone', async ({ page }) => {
  await openTrick(page);
  const pin = firstFigure(page).getByRole('button', { name: /^Pin at vertex 0/ });
  await pin.focus();
  const left = async () => (await pin.boundingBox())?.x ?? 0;
  const before = await left();
  await page.keyboard.press('Shift+ArrowRight');
  await expect.poll(left).toBeCloseTo(before + 40, 0);
  const springs = firstFigure(page).getByRole('listbox', { name: 'Springs' }).first();
  await springs.getByRole('option', { name: /^Spring 6,/ }).focus();
  await page.keyboard.press('ArrowRight');
  const next = springs.getByRole('option', { name: /^Spring 7, .* stretched by \+/ });
  await expect(next).toBeFocused();
  await expect(next).toHaveAttribute('aria-selected', 'true');
  await firstFigure(page).getByRole('button', { name: 'Play' }).press('Enter');
  await expect(place(page)).toHaveText(/^t = (1[1-9]|[2-9]\d)$/);
  await firstFigure(page).getByRole('button', { name: 'Pause' }).press('Enter');
  await expect(place(page)).toContainText('accept');
});

test('the keyboard goes from the top of a section to the next one', async ({ page }) => {
  await openSection(page, 'trick');
  const reached: string[] = [];
  while (reached.length < 120 && !reached.includes('Next Matrices')) {
    await page.keyboard.press('Tab');
    reached.push(
      await page.evaluate(() => {
        const { activeElement } = document;
        return (activeElement?.getAttribute('aria-label') ?? activeElement?.textContent ?? '').trim();
      }),
    );
  }
  for (const name of ['Skip to the text', 'Matrices', 'd projected springs', 'Half-step forward', 'A hint'])
    expect(
      reached.some((one) => one.endsWith(name)),
      name,
    ).toBe(true);
  for (const things of ['Springs', 'Vertices']) {
    const stops = reached.filter((name) => name.startsWith(things === 'Springs' ? 'Spring ' : 'Vertex ')).length;
    expect(stops, `${things}: one tab stop a picture`).toBeGreaterThan(0);
    expect(stops).toBeLessThanOrEqual(await page.getByRole('listbox', { name: things }).count());
  }
  await page.keyboard.press('Enter');
  await expect(page.getByRole('heading', { level: 2 })).toHaveText('Matrices');
  await expect(page.getByRole('heading', { level: 2 })).toBeFocused();
  await expect(page).toHaveURL(/#\/lesson\/matrices/);
});

test('a figure that plays sleeps off the screen and goes on where it was', async ({ page }) => {
  await openTrick(page);
  const figure = firstFigure(page);
  await figure.getByRole('button', { name: 'Play' }).click();
  await expect(place(page)).toHaveText(/^t = 1[1-9]$/);
  await page.locator('.section-neighbours').scrollIntoViewIfNeeded();
  await expect(figure).toHaveAttribute('data-awake', 'false');
  const asleep = Number((await place(page).textContent())?.slice(4));
  await page.getByText('A hint').last().click(); // something else happens meanwhile
  expect(Number((await place(page).textContent())?.slice(4)) - asleep).toBeLessThanOrEqual(1); // one may have been under way
  await figure.scrollIntoViewIfNeeded();
  await expect.poll(async () => Number((await place(page).textContent())?.slice(4))).toBeGreaterThan(asleep + 1);
});

test('a figure opens in the lab at its moment, and the lab keeps it while the lesson is read', async ({ page }) => {
  await openTrick(page);
  await firstFigure(page).getByRole('button', { name: 'Open this in the lab' }).click();
  const status = page.getByTestId('status');
  await expect(status).toHaveText('time step t = 10 · iteration 1 of 4 · local');
  await expect(page.locator('.scene-menu select')).toHaveValue('patch');
  await page.getByRole('button', { name: /^Half-step forward/ }).click();
  await expect(status).toContainText('global');
  await page.getByRole('link', { name: 'Lesson', exact: true }).click();
  await expect(page.getByRole('heading', { level: 2 })).toHaveCount(1); // the lab has several, and goes when the lesson comes
  await page.getByRole('link', { name: 'Springs', exact: true }).click();
  await expect(status).toHaveText('time step t = 10 · iteration 1 of 4 · global');
});

test('a section that does not exist is said, and the first one opens', async ({ page }) => {
  await open(page, lesson('nowhere'));
  await expect(page.getByText('part # = nowhere')).toBeVisible();
  await expect(page.getByRole('heading', { level: 2 })).toHaveText('The model');
});

for (const [width, height] of [
  [1280, 720],
  [390, 844],
])
  test(`nothing moves while the figures load, ${width} px wide`, async ({ page }) => {
    await page.setViewportSize({ width, height });
    await page.addInitScript(() => {
      const shifts: number[] = [];
      Object.assign(globalThis, { shifts });
      new PerformanceObserver((list) => {
        for (const entry of list.getEntries()) shifts.push((entry as unknown as { value: number }).value);
      }).observe({ type: 'layout-shift', buffered: true });
    });
    for (const id of sectionIds) {
      await openSection(page, id);
      for (const figure of await page.locator('.figure').all()) {
        await figure.scrollIntoViewIfNeeded();
        await expect(figure).toHaveAttribute('data-ready', 'true');
      }
      const shifts = await page.evaluate(() => (globalThis as unknown as { shifts: number[] }).shifts.splice(0));
      expect(
        shifts.reduce((sum, value) => sum + value, 0),
        id,
      ).toBeLessThan(0.01); // a tenth of what counts as good
    }
  });

test('nothing is wider than a phone, in any section', async ({ page }) => {
  await page.setViewportSize({ width: 390, height: 844 });
  for (const id of sectionIds) {
    await openSection(page, id);
    expect(await page.evaluate(() => document.documentElement.scrollWidth), id).toBeLessThanOrEqual(390);
    expect(await seriousViolations(page), id).toEqual([]);
  }
});
