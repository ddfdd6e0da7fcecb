import type { Page } from '@playwright/test';
import { defaultKinematics, type KinematicsSettings } from '../../web/src/app/kinematics.ts';
import { en } from '../../web/src/labs/kinematics/settings/en.ts';
import { en as trace } from '../../web/src/labs/kinematics/trace/en.ts';
import { seriousViolations } from './support/axe.ts';
import { expect, open, test } from './support/page.ts';

test.use({ bypassCSP: true }); // for axe, see support/axe.ts

function arm(settings: Partial<KinematicsSettings> = {}, language: 'en' | 'zh' = 'en'): string {
  const kinematics = { ...defaultKinematics, mode: 'aim', ...settings };
  return `#/kinematics?language="${language}"&kinematics=${JSON.stringify(kinematics)}`;
}

const moment = (page: Page) => page.getByTestId('moment');
const outcome = (page: Page) => page.locator('.arm-result');
const method = (page: Page, name: string) =>
  page.locator('.method-choice').getByRole('button', { name, exact: true }).click();
const table = (page: Page) => page.locator('.arm-equation .joint-table').last();

test('CCD is stepped by the keyboard: another joint, another angle, there and back', async ({ page }) => {
  await open(page, arm());
  await expect(outcome(page)).toHaveAttribute('data-outcome', 'CONVERGED');
  await expect(moment(page)).toHaveText(/^iteration (\d+) of \1 · joint 0 turned$/);
  const angle = page.locator('.arm-angle');
  const last = await angle.textContent();
  await page.keyboard.press('ArrowLeft');
  await expect(moment(page)).toContainText('joint 1 turned');
  await expect(angle).not.toHaveText(last as string);
  await page.keyboard.press('ArrowRight');
  await expect(angle).toHaveText(last as string);
  await page.getByRole('button', { name: trace.first }).click();
  await expect(moment(page)).toHaveText(trace.happened.start);
  await page.getByRole('button', { name: trace.iterationForward }).click();
  await expect(moment(page)).toHaveText(/^iteration 1 of \d+ · joint 0 turned$/);
});

test('from the hanging arm the search begins with nothing turned', async ({ page }) => {
  await open(page, arm());
  await page.getByRole('button', { name: trace.hang }).click();
  await expect(moment(page)).toHaveText(trace.happened.start);
  // The end effector of the lab's arm hangs 0.9 m under the floor.
  await expect(table(page).locator('tbody tr').last()).toContainText(/0\.000.*−0\.900.*0\.000/);
});

test('FABRIK goes backward and forward, with numbers in the order of the pass', async ({ page }) => {
  await open(page, arm({ method: 'fabrik' }));
  await page.getByRole('button', { name: trace.hang }).click();
  await expect(moment(page)).toHaveText(trace.happened.start);
  const joints = page.locator('.arm-equation').first().locator('.joint-table tbody th');
  await page.keyboard.press('ArrowRight');
  await expect(moment(page)).toHaveText(/^iteration 1 of \d+ · backward pass$/);
  await expect(joints).toHaveText(['4', '3', '2', '1', '0']);
  await page.keyboard.press('ArrowRight');
  await expect(moment(page)).toContainText('forward pass');
  await expect(joints).toHaveText(['0', '1', '2', '3', '4']);
});

test('another method reaches for the same target, from where the arm was', async ({ page }) => {
  await open(page, arm());
  const effector = table(page).locator('tbody tr').last();
  await method(page, en.methods['least-squares']);
  await expect(page.locator('.arm-equation h3').first()).toHaveText('Damped least squares');
  await expect(effector).toContainText(/0\.600.*0\.300.*0\.400/);
  await expect(outcome(page)).toHaveAttribute('data-outcome', 'CONVERGED');
  await page.keyboard.press('ArrowLeft'); // the keys are the page's again
  await expect(moment(page)).toHaveText(/all joints turned$/);
  await method(page, en.methods.fabrik);
  await expect(moment(page)).toHaveText(/forward pass$/);
});

test('a link is made longer; a length that is none is answered by a sentence', async ({ page }) => {
  await open(page, arm());
  const length = page.getByLabel('Length of the link from joint 1 to joint 2');
  await length.fill('0.55');
  await page.keyboard.press('Enter');
  await expect(table(page).locator('tbody tr').nth(2)).toContainText('0.550');
  await length.fill('long');
  await page.keyboard.press('Enter');
  await expect(page.getByRole('alert')).toContainText('“long” is not a number');
  await length.fill('-1');
  await page.keyboard.press('Enter');
  await expect(page.getByRole('alert')).toContainText('-1 is outside 0.01 … 5');
  await expect(length).toHaveValue('0.55');
  await length.fill('0.7'); // what is typed stays, though the row is lit meanwhile
  await page.locator('.link-list li').last().hover();
  await page.locator('.link-list li').first().hover();
  await expect(length).toHaveValue('0.7');
  await page.keyboard.press('Enter');
  await expect(table(page).locator('tbody tr').nth(2)).toContainText('0.700');
});

test('links come and go, and a bend limit holds the arm', async ({ page }) => {
  await open(page, arm());
  const links = page.locator('.link-list li');
  await page.getByRole('button', { name: en.links.add }).click();
  await expect(links).toHaveCount(5);
  await expect(table(page).locator('tbody tr')).toHaveCount(6);
  await page.getByRole('button', { name: en.arm.presets.two }).click();
  await expect(links).toHaveCount(2);
  const bend = page.getByLabel('Most bend at joint 1');
  await bend.fill('20');
  await page.keyboard.press('Enter');
  await expect(outcome(page)).toHaveAttribute('data-outcome', 'STALLED');
  await expect(outcome(page)).toContainText('Held by its limits');
  await bend.fill('');
  await page.keyboard.press('Enter');
  await expect(outcome(page)).toHaveAttribute('data-outcome', 'CONVERGED');
});

test('a link with a far target opens with the reason why nothing reaches it', async ({ page }) => {
  await open(page, arm({ target: [3, 1.7, 0] }));
  await expect(outcome(page)).toHaveAttribute('data-outcome', 'UNREACHABLE');
  await expect(outcome(page)).toContainText('the target is 3.00 m from the root, and the arm is 2.60 m long');
  await expect(moment(page)).toHaveText(trace.happened.straight);
});

test('a joint that is pointed at in a table is lit, and shown at large', async ({ page }) => {
  await open(page, arm());
  const rowOf = (joint: number) => table(page).locator('tbody tr').nth(joint);
  await rowOf(3).hover();
  await expect(rowOf(3)).toHaveAttribute('data-joint-lit', 'true');
  await expect(page.locator('.arm-joint.pointed')).toHaveText('3'); // in the picture
  await expect(page.locator('.one-joint')).toContainText('joint 3');
  await page.mouse.move(0, 0);
  await expect(page.locator('.one-joint')).toContainText('joint 1');
  await rowOf(2).getByRole('button').focus();
  await expect(rowOf(2)).toHaveAttribute('data-joint-lit', 'true');
  await page.keyboard.press('Enter');
  await expect(page.locator('.one-joint')).toContainText('joint 2');
});

test('a symbol has its card, and is marked in all formulas', async ({ page }) => {
  await open(page, arm());
  await page.locator('.arm-equation .symbol-button[data-sym="R"]').first().focus();
  const card = page.locator('.card[data-kind="symbol"]');
  await expect(card).toContainText('rotation against the world');
  await expect(card).toContainText('3 × 3');
  await expect(page.locator('html')).toHaveAttribute('data-lit', 'R');
});

test('single precision: a small angle is wanted and none is turned, and the page says why', async ({ page }) => {
  await open(page, arm({ precision: 'single', epsilon: 1e-9 }));
  await expect(outcome(page)).toContainText('single precision rounds');
  await expect(page.locator('.arm-equation').first()).toContainText('It turned by 0.0°');
});

for (const language of ['en', 'zh'] as const)
  for (const width of [1280, 390])
    test(`axe finds nothing serious, and nothing is too wide: ${language}, ${width} px`, async ({ page }) => {
      await page.emulateMedia({ reducedMotion: 'reduce' });
      await page.setViewportSize({ width, height: 844 });
      await open(page, arm({}, language));
      for (const name of ['FABRIK', language === 'en' ? en.methods['least-squares'] : '阻尼最小二乘', 'CCD']) {
        await method(page, name);
        for (const summary of await page.locator('main summary').all())
          if (!(await summary.evaluate((element) => (element.parentElement as HTMLDetailsElement).open)))
            await summary.click();
        expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(width);
      }
      expect(await seriousViolations(page)).toEqual([]);
    });
