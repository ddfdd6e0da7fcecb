import type { Locator, Page } from '@playwright/test';
import { sectionIds } from '../../web/src/notation/sections.ts';
import { expect, openSection, test } from './support/page.ts';

test.beforeEach(async ({ page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' }); // every half-step shows at once
});

/** Opens a section with everything that is folded away in it: hints, answers, slips. */
async function openUnfolded(page: Page, id: string): Promise<void> {
  await openSection(page, id);
  for (const summary of await page.locator('.question > details > summary, .folded-slip > summary').all())
    await summary.click();
}

const button = (figure: Locator, name: string) => figure.getByRole('button', { name, exact: true });
const place = (figure: Locator) => figure.locator('.figure-place').first();
/** Where all springs of a figure's pictures are drawn. */
const springs = (figure: Locator) =>
  figure.locator('.coil').evaluateAll((paths) => paths.map((path) => path.getAttribute('d')));
/** All that a figure shows but its controls. */
const shown = (figure: Locator) =>
  figure.evaluate((element) => {
    const copy = element.cloneNode(true) as Element;
    for (const control of copy.querySelectorAll('.figure-transport, .figure-sliders, input')) control.remove();
    return copy.innerHTML;
  });

/** Does something, and waits for what the figure shows to become something else. */
async function changing(figure: Locator, act: () => Promise<void>): Promise<void> {
  const before = await shown(figure);
  await act();
  await expect.poll(async () => (await shown(figure)) !== before).toBe(true);
}

/** The last vertex follows the pointer. */
async function drag(page: Page, figure: Locator): Promise<void> {
  const dot = figure.locator('.vertex .dot').last();
  await dot.scrollIntoViewIfNeeded();
  const middle = async () => {
    const box = (await dot.boundingBox()) as { x: number; y: number; width: number; height: number };
    return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
  };
  const { x, y } = await middle();
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 12, y - 24, { steps: 2 });
  await expect.poll(async () => Math.abs((await middle()).x - x)).toBeGreaterThan(4); // a weak pin lets it lag behind
  await page.mouse.up();
}

async function moveSliders(figure: Locator): Promise<void> {
  for (const slider of await figure.locator('.figure-sliders input').all()) {
    const before = await slider.getAttribute('aria-valuetext');
    const atEnd = (await slider.inputValue()) === (await slider.getAttribute('max'));
    await slider.press(atEnd ? 'ArrowLeft' : 'ArrowRight');
    await expect(slider).not.toHaveAttribute('aria-valuetext', before as string);
  }
}

/** Steps through what needs no solver, to the end and back. */
async function stepThrough(stepper: Locator): Promise<void> {
  const step = stepper.locator('output');
  await button(stepper, 'One step on').click();
  await expect(step).toHaveText(/^1 \/ /);
  await button(stepper, 'To the beginning').click();
  await expect(step).toHaveText(/^0 \/ /);
  await stepper.getByRole('slider').press('End');
}

/** Drags, steps, plays, slides and resets a figure with a clock. */
async function operate(page: Page, figure: Locator): Promise<void> {
  const [beginning, drawn] = [await place(figure).textContent(), await springs(figure)];
  await drag(page, figure);
  await expect(place(figure)).toContainText('accept');
  await button(figure, 'Half-step forward').click();
  await expect(place(figure)).toContainText('predict');
  await changing(figure, () => button(figure, 'One time step').click());
  await expect(place(figure)).toContainText('accept');
  await changing(figure, () => button(figure, 'Play').click());
  await expect(place(figure)).toHaveText(/^t = \d+$/);
  await button(figure, 'Pause').click();
  await moveSliders(figure);
  await button(figure, 'Reset to rest').click();
  await expect(place(figure)).toHaveText(beginning as string);
  await expect.poll(() => springs(figure)).toEqual(drawn); // to the bit
}

async function choose(figure: Locator): Promise<void> {
  for (const choice of await figure.locator('input[type="radio"]:not(:checked), input[type="checkbox"]').all())
    if (!(await choice.isChecked()) || (await choice.getAttribute('type')) === 'checkbox')
      await changing(figure, () => choice.click());
}

for (const id of sectionIds)
  test(`every figure comes up, can be operated, shows it, and resets: ${id}`, async ({ page }) => {
    await openUnfolded(page, id);
    const figures = await page.locator('.figure:has(.figure-to-lab)').all();
    expect(figures.length).toBeGreaterThan(0);
    for (const figure of figures) {
      await figure.scrollIntoViewIfNeeded();
      await expect(figure).toHaveAttribute('data-ready', 'true');
      await operate(page, figure);
      for (const stepper of await figure.locator('.stepper').all()) await changing(figure, () => stepThrough(stepper));
      await choose(figure);
    }
  });

test('nets under one clock go back to the beginning', async ({ page }) => {
  for (const id of ['time', 'optimisation']) {
    await openUnfolded(page, id);
    const experiment = page.locator('.side-by-side');
    await experiment.scrollIntoViewIfNeeded();
    const readings = experiment.locator('.side-by-side-reading');
    for (const net of await experiment.locator('.spring-picture').all())
      await expect(net.locator('.coil').first()).toBeVisible();
    const [said, drawn] = [await readings.allTextContents(), await springs(experiment)];
    await changing(experiment, () => button(experiment, 'Play').click());
    await expect.poll(() => readings.allTextContents()).not.toEqual(said);
    await button(experiment, 'Reset to rest').click();
    await expect(readings).toHaveText(said);
    await expect.poll(() => springs(experiment)).toEqual(drawn);
  }
});

test('one spring alone has an energy with two wells, and every slip in print another gradient', async ({ page }) => {
  for (const id of ['optimisation', 'pins']) {
    await openUnfolded(page, id);
    await page.locator('.figure').first().scrollIntoViewIfNeeded();
    for (const slip of await page.locator('.slip-check').all())
      await expect(slip.locator('tbody tr td:last-child')).toHaveText(['', '✓', '✗']);
    if (id === 'optimisation') {
      const energies = page.locator('.plain-chart .line-chart-tick');
      const before = await energies.allTextContents();
      await page.locator('.figure-sliders input').nth(1).press('End'); // a stiffer spring
      await expect.poll(() => energies.allTextContents()).not.toEqual(before);
    }
  }
});

test('experiments that run by themselves draw and write what comes of them', async ({ page }) => {
  await openUnfolded(page, 'trick');
  const charts = page.locator('.question > details > .figure > .line-chart');
  await expect(charts.first().locator('g.curve path[d*="L"]')).toHaveCount(4);
  await expect(charts.last().locator('g.curve circle')).toHaveCount(7);
  await openUnfolded(page, 'sparse');
  await expect(page.locator('[data-order] td')).toHaveText([/\d/, /\d/]);
});

test('refactorising is timed against a factor that is kept', async ({ page }) => {
  await openUnfolded(page, 'solving');
  const experiment = page.locator('.question .experiment');
  await experiment.getByRole('button').click();
  await expect(experiment.locator('tbody td:last-child')).toHaveText([/\d ×/, /\d ×/], { timeout: 50_000 });
});

test("a task's own source unfolds", async ({ page }) => {
  await openUnfolded(page, 'tasks');
  await page.locator('.task-code > summary').first().click();
  await expect(page.locator('.code-line').first()).toBeVisible();
});

test('the mistakes that the last section asks about can be watched beside the right solver', async ({ page }) => {
  await openUnfolded(page, 'tasks');
  const experiments = page.locator('.mistaken-nets');
  await expect(experiments).toHaveCount(3);
  const notes = (experiment: Locator) => experiment.locator('.net-note').allTextContents();
  const numberIn = (note: string) => Number.parseFloat((/[\d.]+/.exec(note) as RegExpExecArray)[0]);

  const [forgotten, swapped, slow] = await experiments.all();
  await forgotten.scrollIntoViewIfNeeded();
  await button(forgotten, 'Play').click();
  await expect.poll(async () => numberIn((await notes(forgotten))[1])).toBeLessThan(50); // % of the rest length
  expect(numberIn((await notes(forgotten))[0])).toBeGreaterThan(90);

  await swapped.scrollIntoViewIfNeeded();
  await expect(button(forgotten, 'Play')).toBeVisible(); // it stops off the screen
  await button(swapped, 'Play').click();
  await expect(swapped.locator('.net-note').last()).toContainText('stopped');
  await expect(swapped.locator('.net-note').first()).toContainText('kinetic energy');

  await slow.scrollIntoViewIfNeeded();
  await button(slow, 'One time step').click();
  await expect(slow.locator('.net-note')).toContainText([
    /, 1 factorisation/,
    /, 1 factorisation/,
    /, \d\d factorisations/,
  ]);
});

test('only what fits is multiplied, and a push along one axis has one column as its answer', async ({ page }) => {
  await openUnfolded(page, 'pins');
  const fitting = page.locator('.figure', { has: page.locator('.pins-product') });
  await fitting.scrollIntoViewIfNeeded();
  await expect(fitting.locator('tbody tr')).toHaveCount(2); // C p: the two pins
  await fitting.getByRole('radio', { name: 'targets' }).click();
  await expect(fitting.locator('.report')).toContainText('does not fit');
  await fitting.locator('input[name="left"]').nth(1).click();
  await expect(fitting.locator('tbody tr')).toHaveCount(9); // Cᵀ times the targets
  await openUnfolded(page, 'matrices');
  const push = page.locator('.push-columns');
  await push.scrollIntoViewIfNeeded();
  const column = (table: number, axis: number) =>
    push
      .locator('table')
      .nth(table)
      .locator(`tbody td:nth-child(${axis + 2})`);
  await expect(column(0, 1)).toHaveText(['0', '0', '0']);
  await expect(column(1, 1).last()).not.toHaveText('0'); // Newton's
});

test('the entries of a matrix beside a figure open their cards', async ({ page }) => {
  for (const [id, entry] of [
    ['pins', '.plain-matrix td[data-about="Q"]'],
    ['sparse', '.triplets td[data-about="Q"]'],
  ]) {
    await openUnfolded(page, id);
    await page.locator(entry).first().hover();
    await expect(page.getByRole('dialog')).toContainText('row');
    await page.keyboard.press('Escape');
  }
});
