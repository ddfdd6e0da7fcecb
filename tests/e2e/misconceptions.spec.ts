import type { Page } from '@playwright/test';
import { cards } from '../../web/src/labs/springs/misconceptions/cards.ts';
import { en } from '../../web/src/labs/springs/misconceptions/en.ts';
import { seriousViolations } from './support/axe.ts';
import { expect, expectReady, open, test } from './support/page.ts';

test.use({ bypassCSP: true }); // for axe, see support/axe.ts

const room = (language: 'en' | 'zh') => `#/springs/misconceptions?language="${language}"`;
const card = (page: Page, mistake: string) => page.locator(`.mistake[data-mistake="${mistake}"]`);

/** The clock of both nets has gone so far. */
async function expectSteps(page: Page, steps: number): Promise<void> {
  await expect
    .poll(async () => Number(await page.locator('.nets').getAttribute('data-step')), { intervals: [50] })
    .toBeGreaterThanOrEqual(steps);
}

test('every mistake can be looked at, and runs beside the right solver', async ({ page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' }); // or ten simulations would play
  await page.setViewportSize({ width: 800, height: 600 });
  await open(page, room('en'));
  const nets = page.locator('.nets');
  for (const { mistake } of cards) {
    await page.locator(`.cabinet-list [data-mistake="${mistake}"]`).click();
    await expect(nets).toHaveAttribute('data-step', '0');
    await expect(page.locator('.nets-transport .play')).toHaveAttribute('aria-disabled', 'false');
    await page.keyboard.press(' ');
    await expect(nets).toHaveAttribute('data-step', '1');
    await expect(card(page, mistake).locator('.wrong-and-right .katex')).toHaveCount(2);
    await expect(card(page, mistake).locator('.code-listing').first()).toContainText(/\w+\(/);
  }
});

test('a symbol in a mistake’s name opens no card over the list', async ({ page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await open(page, room('en'));
  const symbol = page.locator('.cabinet-list [data-mistake="times-swapped"] [data-sym]').last();
  const { x, y, width, height } = (await symbol.boundingBox()) as NonNullable<
    Awaited<ReturnType<typeof symbol.boundingBox>>
  >;
  await page.mouse.click(x + width / 2, y + height / 2);
  await expect(card(page, 'times-swapped')).toBeVisible();
  await expect(page.locator('#card')).toBeHidden();
});

test('what explodes is stopped and explained, and the page lives on', async ({ page }) => {
  await open(page, room('en'));
  await page.locator('.cabinet-list [data-mistake="times-swapped"]').click();
  await expect(page.locator('.failure').last()).toContainText(
    /vertex \d+ went out of reach .* in time step 30, half-step global\(1\)/,
  );
  await expectSteps(page, 40); // the right net goes on
  await page.locator('.cabinet-list [data-mistake="gradient-as-force"]').click();
  await expect(page.locator('.failure').last()).toBeEmpty();
  await expectSteps(page, 3);
});

test('the keys move the room’s clock and leave the lab’s alone', async ({ page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await open(page, room('en'));
  const nets = page.locator('.nets');
  await expect(page.locator('.nets-transport .play')).toHaveAttribute('aria-disabled', 'false');
  await page.keyboard.press(' ');
  await expect(nets).toHaveAttribute('data-step', '1');
  await page.keyboard.press('ArrowDown');
  await expect(nets).toHaveAttribute('data-step', '2');
  await page.keyboard.press('r');
  await expect(nets).toHaveAttribute('data-step', '0');
  await page.keyboard.press('a');
  await expectSteps(page, 2);
  await page.getByRole('link', { name: 'Local and global', exact: true }).click();
  await expect(page.getByTestId('status')).toContainText('time step t = 1 · iteration 0');
});

test('the quiz by keyboard; its score survives a reload', async ({ page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await open(page, room('en'));
  await page.getByRole('button', { name: en.modes.quiz }).click();
  await expect(page.getByText(en.quiz.noScore)).toBeVisible();
  const mistake = `${await page.locator('.quiz').getAttribute('data-mistake')}`;
  const choices = page.locator('.quiz-choices button');
  await expect(choices).toHaveCount(4);
  await page.locator(`.quiz-choices [data-choice="${mistake}"]`).focus();
  await page.keyboard.press('Enter');
  await expect(page.locator('.quiz-answer')).toContainText(en.quiz.rightAnswer);
  await expect(page.locator('.quiz-score')).toContainText('Right: 1 of 1. Mistakes recognised: 1 of 10.');
  await page.keyboard.press('Enter'); // an answer is given once
  await expect(page.locator('.quiz-score')).toContainText('Right: 1 of 1.');
  await page.getByRole('button', { name: en.quiz.next }).focus();
  await page.keyboard.press('Enter');
  await expect(page.locator('.quiz-answer')).toBeEmpty();
  await expect(page.getByRole('heading', { name: en.quiz.ask })).toBeFocused();
  expect(await page.locator('.quiz').getAttribute('data-mistake')).not.toBe(mistake);

  await page.reload();
  await expectReady(page);
  await expect(page.locator('.cabinet-known')).toHaveCount(1);
  await page.getByRole('button', { name: en.modes.quiz }).click();
  await expect(page.locator('.quiz-score')).toContainText('Right: 1 of 1. Mistakes recognised: 1 of 10.');
  await page.getByRole('button', { name: en.quiz.forget }).click();
  await expect(page.getByText(en.quiz.noScore)).toBeVisible();
});

test('the lab’s scene can be taken, and is said to hide what it hides', async ({ page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await open(page, `${room('en')}&scene="tower"`);
  await page.locator('.cabinet-list [data-mistake="times-swapped"]').click();
  await page.getByRole('button', { name: 'The lab’s: Tower' }).click();
  await expect(page.getByText(en.stage.hides)).toBeVisible();
  await page.locator('.cabinet-list [data-mistake="stored-zeros"]').click();
  await expect(page.getByText(en.stage.hides)).toBeHidden();
});

for (const language of ['en', 'zh'] as const)
  test(`from the lesson and back, on a phone, for everybody, in ${language}`, async ({ page }) => {
    await page.emulateMedia({ reducedMotion: 'reduce' });
    await page.setViewportSize({ width: 390, height: 844 });
    await open(page, `#/lesson/tasks?language="${language}"`);
    await page.locator('a[href$="#/springs/misconceptions"]').last().click();
    await expect(page.locator('.cabinet-list button')).toHaveCount(10);
    await expect(page.locator('.nets-transport .play')).toHaveAttribute('aria-disabled', 'false');
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(390);
    expect(await seriousViolations(page)).toEqual([]);
    await page.locator('.misconceptions > header button').last().click();
    await expect(page.locator('.quiz-choices button')).toHaveCount(4);
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(390);
    expect(await seriousViolations(page)).toEqual([]);
  });
