import type { Page } from '@playwright/test';
import type { IntegratorsSettings, MethodChoice } from '../../web/src/app/integrators.ts';
import { en } from '../../web/src/labs/integrators/en.ts';
import { seriousViolations } from './support/axe.ts';
import { expect, open, openSection, test } from './support/page.ts';

test.use({ bypassCSP: true }); // for axe, see support/axe.ts

const choice = (method: MethodChoice['method'], iterations = 1, substeps = 1) => ({ method, iterations, substeps });
const four = [
  choice('symplectic-euler', 1, 16),
  choice('linearly-implicit'),
  choice('newton', 1000),
  choice('local-global', 10),
];

function lab(settings: Partial<IntegratorsSettings>, language: 'en' | 'zh' = 'en'): string {
  const usual = { scene: 'cloth', methods: four, parameters: {}, poke: { stiffness: null, radius: 0.06 } };
  return `#/integrators?language="${language}"&integrators=${JSON.stringify({ ...usual, ...settings })}`;
}

const nets = (page: Page) => page.locator('.nets');
const stepOf = async (page: Page) => Number(await nets(page).getAttribute('data-step'));

/** The canvas lies over the nets' views and over nothing else: what it covered besides could neither be seen nor clicked. */
async function expectCanvasOnViews(page: Page): Promise<void> {
  const excess = () =>
    page.evaluate(() => {
      const box = (element: Element | null) => (element as Element).getBoundingClientRect();
      const views = [...document.querySelectorAll('.net-view')].map(box);
      const canvas = box(document.querySelector('.nets-canvas'));
      const [left, top] = [Math.min(...views.map((view) => view.left)), Math.min(...views.map((view) => view.top))];
      const [right, bottom] = [
        Math.max(...views.map((view) => view.right)),
        Math.max(...views.map((view) => view.bottom)),
      ];
      return Math.max(left - canvas.left, top - canvas.top, canvas.right - right, canvas.bottom - bottom);
    });
  await expect.poll(excess).toBeLessThanOrEqual(2); // it ends at whole pixels
}

/** The clock has gone so far. */
async function expectSteps(page: Page, steps: number): Promise<void> {
  await expect.poll(() => stepOf(page), { intervals: [50] }).toBeGreaterThanOrEqual(steps);
}

test('four methods run on one clock, which keys move, and are compared in curves and numbers', async ({ page }) => {
  await open(page, lab({}));
  await expect(page.locator('.net h4')).toHaveText([
    'Symplectic Euler, 16 substeps',
    'Linearly implicit Euler',
    'Newton, converged',
    'Local/global × 10',
  ]);
  await expect(nets(page)).toHaveAttribute('data-step', '0');
  await page.keyboard.press(' ');
  await expect(nets(page)).toHaveAttribute('data-step', '1');
  await page.keyboard.press('a');
  await expectSteps(page, 70); // a second of simulated time and more
  await page.keyboard.press('a');
  const rows = page.locator('.results').first().locator('tbody tr');
  await expect(rows).toHaveCount(4);
  for (const row of await rows.all()) await expect(row).toContainText(/J\/s.*ms$/);
  for (const curve of [0, 1, 2, 3])
    await expect(page.locator('.integrators-evidence figure').first().locator(`svg g.curve-${curve}`)).toHaveCount(1);
});

test('forward Euler’s explosion is explained; the others go on, and starting again brings it back', async ({
  page,
}) => {
  await open(
    page,
    lab({ methods: [choice('forward-euler'), choice('linearly-implicit')], parameters: { damping: 0 } }),
  );
  await page.keyboard.press('a');
  const failure = page.locator('.integrators-failure').first();
  await expect(failure).toContainText(/^Forward Euler exploded at time step \d+ \(Δt·ω = \d.*Start again/, {
    timeout: 60_000,
  });
  const then = await stepOf(page);
  await expectSteps(page, then + 10);
  await expect(page.locator('.integrators-failure').last()).toBeEmpty();
  await page.keyboard.press('r');
  await expect(failure).toBeEmpty();
  await page.keyboard.press(' ');
  await expect(nets(page)).toHaveAttribute('data-step', '1');
  await expect(failure).toBeEmpty();
});

test('the rabbit’s ear is pulled, and swings after it is let go', async ({ page }) => {
  await open(page, lab({ scene: 'rabbit', methods: [choice('linearly-implicit')] }));
  const view = (await page.locator('.net-view').boundingBox()) as NonNullable<
    Awaited<ReturnType<ReturnType<Page['locator']>['boundingBox']>>
  >;
  // The ears are the highest part: from above, the first place that is taken hold of belongs to them.
  let y = view.y;
  const x = view.x + view.width * 0.56;
  while ((await nets(page).getAttribute('data-pulled')) === '0' && y < view.y + view.height / 2) {
    await page.mouse.up();
    y += 12;
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + 8, y);
  }
  await page.mouse.move(x + 60, y, { steps: 4 });
  await expect(nets(page)).not.toHaveAttribute('data-pulled', '0');
  await expectSteps(page, 3);
  await page.mouse.up();
  await expect(nets(page)).toHaveAttribute('data-pulled', '0');
  await expectSteps(page, (await stepOf(page)) + 3);
});

test('the rabbit is pulled with the keyboard, and the handle stays in the picture however far', async ({ page }) => {
  await open(page, lab({ scene: 'rabbit', methods: [choice('local-global', 10), choice('newton')] }));
  const handle = page.locator('.poke-handle');
  await handle.focus();
  await page.keyboard.press('Enter');
  for (let press = 0; press < 20; press++) await page.keyboard.press('Shift+ArrowRight');
  await expect(nets(page)).not.toHaveAttribute('data-pulled', '0');
  await expectSteps(page, 10);
  const boxOf = (selector: string) =>
    page.evaluate((one) => {
      const { left, right, top, bottom } = (document.querySelector(one) as Element).getBoundingClientRect();
      return { left, right, top, bottom };
    }, selector);
  const [inner, outer] = [await boxOf('.poke-handle'), await boxOf('.net-view')];
  // Canvases begin and end at whole pixels.
  expect(inner.left).toBeGreaterThan(outer.left - 2);
  expect(inner.right).toBeLessThan(outer.right + 2);
  expect(inner.top).toBeGreaterThan(outer.top - 2);
  expect(inner.bottom).toBeLessThan(outer.bottom + 2);
  await page.keyboard.press('Escape');
  await expect(nets(page)).toHaveAttribute('data-pulled', '0');
  await expect(handle).toBeFocused();
});

test('the same instant: Newton’s method finds the minimiser, ten iterations do not', async ({ page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await open(page, lab({}));
  for (const _ of [1, 2, 3]) await page.keyboard.press(' ');
  await expect(nets(page)).toHaveAttribute('data-step', '3');
  await page.getByRole('button', { name: en.instant.go }).click();
  const rows = page.locator('.same-instant tbody tr');
  await expect(rows).toHaveCount(4);
  await expect(nets(page)).toHaveAttribute('data-step', '4');
  await expect(rows.nth(3).locator('td').first()).not.toHaveText(/^0/);
});

test('methods and settings are changed while it runs, and a link opens the same comparison', async ({ page }) => {
  await open(page, lab({ methods: [choice('local-global', 10)] }));
  await page.keyboard.press('a');
  await expectSteps(page, 3);
  await page.getByRole('button', { name: en.methods.add }).click();
  await page.getByLabel('Method 2').selectOption('chebyshev');
  await page.locator('#compared-k').fill('250');
  await page.keyboard.press('Enter');
  await expect(page.locator('.net h4')).toHaveText(['Local/global × 10', 'Chebyshev × 10']);
  await expectCanvasOnViews(page);
  await expectSteps(page, (await stepOf(page)) + 3);
  await expect.poll(() => page.url()).toContain('chebyshev');
  await expect.poll(() => page.url()).toContain('%22k%22:250');
  await page.reload();
  await expect(page.locator('.net h4')).toHaveText(['Local/global × 10', 'Chebyshev × 10']);
  await expect(page.locator('#compared-k')).toHaveValue('250');
});

test('the lesson’s explicit forces lead here and back, and the springs lab stays as it was', async ({ page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await openSection(page, 'optimisation');
  for (const summary of await page.locator('.question > details > summary').all()) await summary.click();
  await page.locator('a[href^="#/integrators"]').last().click();
  await expect(page.locator('.net h4').first()).toHaveText('Forward Euler');
  await page.locator('.method-cards a').first().click();
  await expect(page.locator('.sources')).toBeVisible();
  await page.getByRole('link', { name: 'Springs', exact: true }).click();
  await expect(page.getByTestId('status')).toContainText('time step t = 1');
});

for (const language of ['en', 'zh'] as const)
  for (const viewport of [
    { width: 1280, height: 720 },
    { width: 390, height: 844 },
  ])
    test(`axe finds nothing serious, and nothing is too wide: ${language}, ${viewport.width} px`, async ({ page }) => {
      await page.emulateMedia({ reducedMotion: 'reduce' });
      await page.setViewportSize(viewport);
      await open(page, lab({}, language));
      for (const _ of [1, 2, 3]) await page.keyboard.press(' ');
      await page.keyboard.press('i');
      await expect(page.locator('.same-instant tbody tr')).toHaveCount(4);
      expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(viewport.width);
      expect(await seriousViolations(page)).toEqual([]);
    });
