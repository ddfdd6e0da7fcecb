import { writeFile } from 'node:fs/promises';
import type { Page, TestInfo } from '@playwright/test';
import { writtenScene } from '../../scenes/rules/written_scene.ts';
import { tetrahedralBlock } from '../support/tetrahedral_block.ts';
import { mark, startTracing, stopTracing } from './support/main_thread.ts';
import { expect, open, test } from './support/page.ts';

const progress = (page: Page) => page.getByRole('progressbar');

/** Chooses the files of a block of side³ vertices. From a folder, since files handed over as bytes keep the page itself busy. */
async function chooseBlock(page: Page, testInfo: TestInfo, side: number): Promise<void> {
  const cells = [side - 1, side - 1, side - 1];
  const files = [...writtenScene({ ...tetrahedralBlock(cells), name: `block-${side}` })];
  await Promise.all(files.map(([name, text]) => writeFile(testInfo.outputPath(name), text)));
  await page.locator('input[type="file"]').setInputFiles(files.map(([name]) => testInfo.outputPath(name)));
}

/** The net is as it was, and goes on. */
async function expectNetGoesOn(page: Page): Promise<void> {
  await expect(progress(page)).toBeHidden();
  await expect(page.getByRole('combobox', { name: /^Scene/ })).toHaveValue('net');
  await page.getByRole('button', { name: 'One time step', exact: true }).click();
  await expect(page.getByTestId('status')).toContainText('time step t = 1 · iteration 50 of 50 · accept');
}

test.beforeEach(async ({ page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' }); // then the net waits at the first time step's predict
  await open(page, './#/springs?scene="net"');
});

test('27,000 vertices factorise while the page stays awake and tells how far they are', async ({
  page,
  browser,
}, testInfo) => {
  await startTracing(browser, page);
  const percents = await page.evaluateHandle((mark) => {
    const told: number[] = [];
    new MutationObserver(() => {
      const percent = Number.parseInt(document.querySelector('.progress-share')?.textContent ?? '', 10);
      if (percent === told.at(-1) || Number.isNaN(percent)) return;
      told.push(percent);
      performance.mark(mark);
    }).observe(document.body, { subtree: true, childList: true, characterData: true });
    performance.mark(mark);
    return told;
  }, mark);
  await chooseBlock(page, testInfo, 30);
  await expect(page.getByText('27000 vertices, 178379 springs')).toBeVisible();
  // From the choice of the files to the last that was told: reading, ordering and factorising, but not the drawing that follows.
  const tasks = await stopTracing(browser);
  expect(tasks.length).toBeGreaterThan(10);
  // The longest takes some 25 to 40 ms. Where the machine is shared, even processor time is stretched now and then: once is chance, twice is the page.
  const [longest, next] = tasks.toSorted((a, b) => b - a);
  expect(next).toBeLessThan(50);
  expect(longest).toBeLessThan(100);
  const told = await percents.jsonValue();
  expect(told.length).toBeGreaterThan(10);
  expect(told).toEqual(told.toSorted((a, b) => a - b));
});

test('a factorisation that takes too long is given up, and the scene before goes on', async ({ page }, testInfo) => {
  await chooseBlock(page, testInfo, 35);
  await expect(progress(page)).toBeVisible();
  await page.getByRole('button', { name: 'Cancel' }).click();
  await expect(page.getByText('Cancelled. Everything is as it was.')).toBeVisible();
  await expectNetGoesOn(page);
});

test('Escape gives up, too', async ({ page }, testInfo) => {
  await chooseBlock(page, testInfo, 35);
  await expect(progress(page)).toBeVisible();
  await page.keyboard.press('Escape');
  await expectNetGoesOn(page);
});

test('a block whose factor would not fit is refused, with both numbers, and the scene before goes on', async ({
  page,
}, testInfo) => {
  await chooseBlock(page, testInfo, 36);
  await expect(
    page.getByText('This would need 190.9 MB of memory, and the solver takes 180.0 MB at most.'),
  ).toBeVisible();
  await expectNetGoesOn(page);
});
