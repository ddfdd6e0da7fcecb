import type { Locator, Page } from '@playwright/test';
import { expect, openSection, test } from './support/page.ts';

/** Opens the answer of a question and brings its experiment on the screen. */
async function answer(page: Page, question: number): Promise<Locator> {
  const card = page.locator('.question').nth(question);
  await card.getByText('The answer').click();
  const experiment = card.locator('.side-by-side');
  await experiment.scrollIntoViewIfNeeded();
  return experiment;
}

/** Simulated time and energy under each picture, s and J. */
async function readings(experiment: Locator): Promise<{ time: number; energy: number }[]> {
  const texts = await experiment.locator('.side-by-side-reading').allTextContents();
  return texts.map((text) => {
    const [time, energy] = text.replaceAll('−', '-').match(/-?\d+(\.\d+)?/g) as string[];
    return { time: Number(time), energy: Number(energy) };
  });
}

test('time: the three positions make velocity and acceleration', async ({ page }) => {
  await openSection(page, 'time');
  await page.locator('figure.figure').scrollIntoViewIfNeeded();
  const table = page.locator('.difference-table');
  await expect(table.locator('tbody tr')).toHaveCount(5);
  const column = await table.locator('tbody tr td:nth-child(3)').allTextContents(); // y
  const [before, now, next, velocity, acceleration] = column.map((text) => Number(text.replace('−', '-')));
  const delta_t = 0.08;
  // Positions are shown to a millimetre.
  expect(Math.abs((now - before) / delta_t - velocity)).toBeLessThan(0.02);
  expect(Math.abs((next - 2 * now + before) / delta_t ** 2 - acceleration)).toBeLessThan(0.4);
});

test('time: of four nets, longer steps lose more energy', async ({ page }) => {
  await openSection(page, 'time');
  const experiment = await answer(page, 0);
  await experiment.getByRole('button', { name: /^Play/ }).click();
  await expect
    .poll(async () => (await readings(experiment)).every(({ time }) => time >= 5), { timeout: 15_000 })
    .toBe(true);
  const energies = (await readings(experiment)).map(({ energy }) => energy);
  expect(energies).toEqual([...energies].sort((a, b) => b - a));
  expect(energies[0]).toBeLessThan(0);
});

test('optimisation: the half-steps walk down to where the gradient is zero', async ({ page }) => {
  await openSection(page, 'optimisation');
  const figure = page.locator('figure.figure');
  await figure.scrollIntoViewIfNeeded();
  await expect(figure.locator('.contour')).toHaveCount(14);
  const slope = figure.locator('.landscape-values dd').last();
  await expect(slope).toContainText('19.4');
  await figure.getByRole('button', { name: 'One time step' }).click();
  await expect(slope).toContainText('× 10⁻');
});

test('optimisation: it is said when an explosion left the picture, until all begins again', async ({ page }) => {
  await openSection(page, 'optimisation');
  const experiment = await answer(page, 1);
  const [explicit, implicit] = await experiment.locator('.side-by-side-reading').all();
  await experiment.getByRole('button', { name: /^Play/ }).click();
  const leaving = /left the picture at t = [\d.]+\ss\./;
  await expect(explicit).toContainText(leaving);
  const [said] = leaving.exec((await explicit.textContent()) as string) as RegExpExecArray;
  await expect.poll(async () => (await readings(experiment))[0].energy).toBeGreaterThan(1e4);
  await expect(explicit).toContainText(said); // the first time, not the last
  await expect(implicit).not.toContainText('left the picture');
  await experiment.getByRole('button', { name: 'Reset to rest' }).click();
  await expect(explicit).not.toContainText('left the picture');
});

test('optimisation: forces at the start of the step explode, until Δt ω is less than 2', async ({ page }) => {
  await openSection(page, 'optimisation');
  const experiment = await answer(page, 1);
  await experiment.getByRole('button', { name: /^Play/ }).click();
  await expect(experiment.locator('.verdict')).toContainText('unstable');
  await expect.poll(async () => (await readings(experiment))[0].energy).toBeGreaterThan(1e4);
  expect((await readings(experiment))[1].energy).toBeLessThanOrEqual(0);

  await experiment.getByRole('slider').last().focus();
  for (let press = 0; press < 12; press++) await page.keyboard.press('ArrowLeft');
  await expect(experiment.locator('.verdict')).not.toContainText('unstable');
  await expect.poll(async () => (await readings(experiment))[0].time).toBeGreaterThan(1);
  expect(Math.abs((await readings(experiment))[0].energy)).toBeLessThan(5);
});
