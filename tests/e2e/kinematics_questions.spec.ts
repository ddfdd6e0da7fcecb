import type { Locator, Page } from '@playwright/test';
import { en } from '../../web/src/labs/kinematics/questions/en.ts';
import { zh } from '../../web/src/labs/kinematics/questions/zh.ts';
import { seriousViolations } from './support/axe.ts';
import { expect, open, test } from './support/page.ts';

test.use({ bypassCSP: true }); // for axe, see support/axe.ts

type Question = 'unreachable' | 'iterations' | 'jitter';

const question = (page: Page, id: Question) => page.locator(`#question-${id}`);
const slider = (page: Page, name: string) => page.getByRole('slider', { name, exact: true });

/** The page, with the question in sight, where its experiment begins. */
async function ask(page: Page, id: Question, language: 'en' | 'zh' = 'en'): Promise<void> {
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await open(page, `#/kinematics?language="${language}"`);
  await question(page, id).scrollIntoViewIfNeeded();
}

const expectAnswered = (page: Page, id: Question) =>
  expect(question(page, id).locator('[data-answered]')).toHaveAttribute('data-answered', 'true');

/** The cells of a row of numbers. */
const cells = (row: Locator) => row.locator('td').allInnerTexts();

/** Hint and answer are folded at first. */
async function openAnswer(page: Page, id: Question): Promise<void> {
  for (const summary of await question(page, id).locator('.question summary').all()) await summary.click();
  await expect(question(page, id).locator('.question details[open]')).toHaveCount(2);
}

test('out of reach: the distance decides at once, the search alone uses up its iterations and creeps on', async ({
  page,
}) => {
  await ask(page, 'unreachable');
  await expectAnswered(page, 'unreachable');
  const section = question(page, 'unreachable');
  await expect(section.locator('.question-verdict')).toContainText(
    /^UNREACHABLE, after 0 iterations: 0\.130.m too far/,
  );
  const [asked, alone, left, creeps] = await cells(section.locator('[data-method="ccd"]'));
  expect([asked, alone]).toEqual(['0', '100']);
  expect(left).toMatch(/mm$/);
  expect(creeps).toMatch(/mm$/);
  // The target and the arm turn by the same angle.
  const [target, arm] = (await section.locator('.question-fact').innerText()).match(/[\d.]+°/g) as string[];
  expect(arm).toBe(target);
  await openAnswer(page, 'unreachable');
});

test('the target is dragged into reach by the mouse, and by keys into the hole of a long last link', async ({
  page,
}) => {
  await ask(page, 'unreachable');
  await expectAnswered(page, 'unreachable');
  const verdict = question(page, 'unreachable').locator('.question-verdict');
  const dot = (await question(page, 'unreachable').locator('.side-view-target .touch').boundingBox()) as {
    x: number;
    y: number;
    width: number;
  };
  await page.mouse.move(dot.x + dot.width / 2, dot.y + dot.width / 2);
  await page.mouse.down();
  await page.mouse.move(dot.x - 20, dot.y, { steps: 4 });
  await page.mouse.up();
  await expect(verdict).toHaveText(en.unreachable.within);

  await slider(page, en.unreachable.distance).press('Home');
  await slider(page, en.unreachable.last).press('End');
  await expect(verdict).toHaveAttribute('data-where', 'tooNear');
  await expect(slider(page, en.unreachable.distance)).toHaveAttribute('aria-valuetext', /^50\.0.mm\. UNREACHABLE/);
  // 2·3 − (1.4 + 3) = 1.6 m, of which the target is 0.05 m away.
  await expect(verdict).toContainText(/1\.55.m too near/);
  for (const method of ['ccd', 'fabrik', 'least-squares'])
    await expect(question(page, 'unreachable').locator(`[data-method="${method}"] td`).first()).toHaveText('0');
});

test('the iterations of all targets: CCD stalls in single precision until ε is large enough for its angles', async ({
  page,
}) => {
  await ask(page, 'iterations');
  const section = question(page, 'iterations');
  await section.getByRole('button', { name: /^Count for 400/ }).click();
  await expectAnswered(page, 'iterations');
  await expect(section.locator('.histogram svg')).toHaveCount(6);
  const row = (precision: string) => section.locator(`[data-method="ccd"][data-precision="${precision}"]`);
  const [median, most, converged] = (await cells(row('double'))).map(Number);
  expect(median).toBeLessThanOrEqual(25);
  expect(most).toBeLessThanOrEqual(25);
  expect(converged).toBe(400);
  const stalled = Number((await cells(row('single')))[3]);
  expect(stalled).toBeGreaterThan(360);
  await expect(section.locator('.question-fact')).toHaveAttribute('data-enough', 'false');

  // 1e-4, 2e-4, 5e-4, 1e-3, 2e-3 m
  for (let press = 0; press < 4; press++) await slider(page, en.iterations.epsilon).press('ArrowRight');
  await expect(section.locator('[data-epsilon]')).toHaveAttribute('data-epsilon', '0.002');
  expect((await cells(row('single')))[3]).toBe('0');
  await expect(section.locator('.question-fact')).toHaveAttribute('data-enough', 'true');
  await openAnswer(page, 'iterations');
});

test('the count is started by the keyboard, along the drawn curve too, and the button keeps the focus', async ({
  page,
}) => {
  await ask(page, 'iterations');
  const section = question(page, 'iterations');
  await section.getByRole('button', { name: en.curves.drawn }).press('Enter');
  const count = section.getByRole('button', { name: /^Count for/ });
  await count.press('Enter');
  await expectAnswered(page, 'iterations');
  await expect(count).toBeFocused();
  await section.locator('.line-chart-numbers summary').first().press('Enter');
  await expect(section.locator('.line-chart-numbers table').first().locator('tbody tr').first()).toBeVisible();
});

test('jitter: random starts flip the arm, a limit holds it back and costs accuracy', async ({ page }) => {
  await ask(page, 'jitter');
  await expectAnswered(page, 'jitter');
  const section = question(page, 'jitter');
  const row = (sweep: string) => cells(section.locator(`[data-sweep="${sweep}"]`));
  const degrees = (text: string) => Number(text.replace('°', ''));
  expect(degrees((await row('random'))[0])).toBeGreaterThan(90);
  expect(degrees((await row('warm'))[0])).toBeLessThan(10);
  expect((await row('limited'))[0]).toBe('2.00°');
  expect((await row('limited'))[2]).toMatch(/mm$/);

  await page.getByLabel(en.jitter.sides.second).selectOption('limited');
  await expect(section.locator('.jitter-charts .line-chart-names').first()).toContainText(en.jitter.names.limited);
  await slider(page, en.jitter.limit).press('ArrowLeft');
  await expect.poll(async () => (await row('limited'))[0]).toBe('1.00°');
  await slider(page, en.jitter.place).press('End');
  await expect(section.locator('.onion-skin').first()).toHaveAttribute('aria-label', /53 to 60/);
  await slider(page, en.jitter.count).press('Home');
  await expect(section.locator('.onion-skin').first()).toHaveAttribute('aria-label', /13 to 20/);
  await section.getByRole('button', { name: en.curves.circle }).click();
  await expect.poll(async () => degrees((await row('random'))[0])).toBeGreaterThan(90);
  await openAnswer(page, 'jitter');
});

for (const language of ['en', 'zh'] as const)
  for (const viewport of [
    { width: 1280, height: 720 },
    { width: 390, height: 844 },
  ])
    test(`axe finds nothing serious, and nothing is too wide: ${language}, ${viewport.width} px`, async ({ page }) => {
      await page.setViewportSize(viewport);
      await ask(page, 'iterations', language);
      const words = { en, zh }[language];
      const start = words.iterations.go.replace('{{targets}}', '400');
      await question(page, 'iterations').getByRole('button', { name: start }).click();
      for (const id of ['unreachable', 'iterations', 'jitter'] as const) {
        await question(page, id).scrollIntoViewIfNeeded();
        await expectAnswered(page, id);
        await openAnswer(page, id);
      }
      // Tables that are wider than the page would be cut off without making it scroll.
      for (const table of await page.locator('.question-table').all()) {
        const { x, width } = (await table.boundingBox()) as { x: number; width: number };
        expect(x).toBeGreaterThanOrEqual(0);
        expect(x + width).toBeLessThanOrEqual(viewport.width);
      }
      expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(viewport.width);
      expect(await seriousViolations(page)).toEqual([]);
    });
