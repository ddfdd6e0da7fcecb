import type { Page } from '@playwright/test';
import { defaultKinematics, type KinematicsSettings } from '../../web/src/app/kinematics.ts';
import { en } from '../../web/src/views/scene3d/arm_en.ts';
import { zh } from '../../web/src/views/scene3d/arm_zh.ts';
import { seriousViolations } from './support/axe.ts';
import { expect, open, test } from './support/page.ts';

test.use({ bypassCSP: true }); // for axe, see support/axe.ts

function lab(settings: Partial<KinematicsSettings> = {}, language: 'en' | 'zh' = 'en'): string {
  return `#/kinematics?language="${language}"&kinematics=${JSON.stringify({ ...defaultKinematics, mode: 'aim', ...settings })}`;
}

const target = (page: Page) => page.locator('.target-handle');
const arm = (page: Page) => page.locator('.arm');
const canvas = (page: Page) => page.locator('.arm-canvas');

/** CSS pixels of the page: the middle of what is there. */
async function middleOf(locator: ReturnType<typeof target>): Promise<{ x: number; y: number }> {
  const box = await locator.boundingBox();
  if (!box) throw new Error('nothing is there');
  return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
}

/** m: x, y, z as the handle says them. */
async function placeSaid(page: Page): Promise<number[]> {
  const label = (await target(page).getAttribute('aria-label')) ?? '';
  const numbers = /x (\S+), y (\S+), z (\S+) m/.exec(label) ?? [];
  return numbers.slice(1).map((text) => Number(text.replace('−', '-')));
}

async function drag(page: Page, from: { x: number; y: number }, ...by: (readonly [number, number])[]): Promise<void> {
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  for (const [dx, dy] of by) await page.mouse.move(from.x + dx, from.y + dy, { steps: 8 });
  await page.mouse.up();
}

test('the mouse drags the target, and far away it is out of reach', async ({ page }) => {
  await open(page, lab());
  await expect(target(page)).toHaveAccessibleName(/x 0\.600, y 0\.300, z 0\.400 m\. Reached/);
  await drag(page, await middleOf(target(page)), [60, -60]);
  await expect(target(page)).toHaveAccessibleName(/Reached/);
  expect((await placeSaid(page))[1]).toBeGreaterThan(0.31); // it went up on the screen
  await drag(page, await middleOf(target(page)), [400, -60]);
  await expect(target(page)).toHaveAccessibleName(/Out of reach: the arm ends .* mm short of it/);
});

for (const width of [1280, 390])
  test(`nothing moves on the page as the target goes out of reach (${width} px)`, async ({ page }) => {
    await page.setViewportSize({ width, height: 800 });
    await open(page, lab());
    await expect(target(page)).toHaveAccessibleName(/Reached/);
    const before = await page.locator('.trace').boundingBox();
    await target(page).focus();
    for (let press = 0; press < 30; press++) await page.keyboard.press('Shift+ArrowRight');
    await expect(page.locator('.arm-result')).toHaveAttribute('data-outcome', 'UNREACHABLE');
    expect(await page.locator('.trace').boundingBox()).toEqual(before);
  });

test('its shadow moves it level with the floor', async ({ page }) => {
  await open(page, lab({ target: [0, 1, 0] }));
  await expect(target(page)).toHaveAccessibleName(/Reached/);
  // The pen begins at the origin, below the target, and so says where on the screen that is.
  await page.getByRole('button', { name: en.draw }).click();
  const shadow = await middleOf(page.locator('.pen-handle'));
  await page.getByRole('button', { name: en.draw }).click();
  const [, height] = await placeSaid(page);
  await drag(page, shadow, [80, 10]);
  await expect.poll(async () => (await placeSaid(page))[0]).toBeGreaterThan(0.05);
  expect((await placeSaid(page))[1]).toBe(height);
});

test.describe('with fingers', () => {
  test.use({ hasTouch: true, viewport: { width: 390, height: 844 } });

  test('the target is dragged', async ({ page }) => {
    await open(page, lab());
    await expect(target(page)).toHaveAccessibleName(/Reached/);
    const { x, y } = await middleOf(target(page));
    const devtools = await page.context().newCDPSession(page);
    const touch = (type: 'touchStart' | 'touchMove' | 'touchEnd', touchPoints: { x: number; y: number }[]) =>
      devtools.send('Input.dispatchTouchEvent', { type, touchPoints });
    await touch('touchStart', [{ x: x + 15, y }]); // a finger is thick
    for (const step of [20, 40, 60]) await touch('touchMove', [{ x: x + 15, y: y - step }]);
    await touch('touchEnd', []);
    await expect.poll(async () => (await placeSaid(page))[1]).toBeGreaterThan(0.31);
  });
});

test('keys move the target as the reader sees it, away and nearer, until it is out of reach', async ({ page }) => {
  await open(page, lab());
  await target(page).focus();
  await page.keyboard.press('ArrowUp');
  await expect.poll(async () => (await placeSaid(page))[1]).toBeGreaterThan(0.3);
  await page.keyboard.press('PageUp');
  await expect.poll(async () => (await placeSaid(page))[2]).toBeLessThan(0.4);
  for (let press = 0; press < 40; press++) await page.keyboard.press('Shift+ArrowRight');
  await expect(target(page)).toHaveAccessibleName(/Out of reach/);
  await expect(page.locator('[aria-live]').filter({ hasText: /Out of reach/ })).toHaveCount(1); // after a while of quiet
  await expect(target(page)).toBeFocused();
});

test('what is drawn on the floor becomes the curve, stroke by stroke, until it is cleared', async ({ page }) => {
  await open(page, lab());
  await page.getByRole('button', { name: en.draw }).click();
  await expect(arm(page)).toHaveAttribute('data-strokes', '0');
  const { x, y } = await middleOf(canvas(page));
  await drag(page, { x: x - 100, y: y + 60 }, [80, 20], [160, -10]);
  await expect(arm(page)).toHaveAttribute('data-strokes', '1');
  await drag(page, { x: x - 60, y: y + 100 }, [120, 0]);
  await expect(arm(page)).toHaveAttribute('data-strokes', '2');
  const link = async () => decodeURIComponent(page.url());
  await expect.poll(link).toContain('"kind":"hand"');
  await page.getByRole('button', { name: en.clear }).click();
  await expect(arm(page)).toHaveAttribute('data-strokes', '0');
  await drag(page, { x: x - 60, y: y + 100 }, [120, 0]);
  await expect(arm(page)).toHaveAttribute('data-strokes', '1');
});

test('keys draw on the floor', async ({ page }) => {
  await open(page, lab());
  const toggle = page.getByRole('button', { name: en.draw });
  await toggle.focus();
  await page.keyboard.press('Enter');
  const pen = page.locator('.pen-handle');
  await expect(pen).toBeFocused();
  await expect(pen).toHaveAccessibleName(/x 0\.00, y 0\.00 m, lifted/);
  await page.keyboard.press('Shift+ArrowRight');
  await page.keyboard.press(' ');
  for (let press = 0; press < 3; press++) await page.keyboard.press('Shift+ArrowUp');
  await expect(pen).toHaveAccessibleName(/x 0\.10, y 0\.30 m, on the floor/);
  await expect(pen).toHaveAttribute('aria-pressed', 'true');
  await page.keyboard.press('Enter');
  await expect(arm(page)).toHaveAttribute('data-strokes', '1');
  await expect(toggle).toBeFocused();
  await expect(toggle).toHaveAttribute('aria-pressed', 'false');
});

test('clearing the drawing leaves the keyboard where it is', async ({ page }) => {
  await open(
    page,
    lab({
      mode: 'draw',
      curve: {
        kind: 'hand',
        strokes: [
          [
            [0, 0],
            [0.3, 0],
          ],
        ],
      },
    }),
  );
  await page.getByRole('button', { name: en.draw }).click();
  const clear = page.getByRole('button', { name: en.clear });
  await clear.press('Enter');
  await expect(arm(page)).toHaveAttribute('data-strokes', '0');
  await expect(clear).toBeDisabled();
  await expect(clear).toBeFocused();
});

test('the header is skipped, and the target comes next', async ({ page }) => {
  await open(page, lab());
  await page.getByRole('button', { name: 'Skip to the transport' }).press('Enter');
  await page.keyboard.press('Tab');
  await expect(target(page)).toBeFocused();
});

test('a joint under the mouse is lit in the picture, and its number with it', async ({ page }) => {
  await open(page, lab());
  const { x, y } = await middleOf(page.locator('.arm-joint').nth(1));
  await page.mouse.move(x - 20, y); // the joint is to the left of its number
  await expect(page.locator('.arm-joint.pointed')).toHaveText('1');
  await page.mouse.move(2, 2);
  await expect(page.locator('.arm-joint.pointed')).toHaveCount(0);
});

for (const [language, words] of [['en', en] as const, ['zh', zh] as const]) {
  test(`everybody can use it, on a phone too (${language})`, async ({ page }) => {
    await page.setViewportSize({ width: 390, height: 844 });
    await open(page, lab({}, language));
    await page.getByRole('button', { name: words.draw }).click();
    await expect(page.locator('.pen-handle')).toBeAttached();
    expect(await seriousViolations(page)).toEqual([]);
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(390);
  });
}
