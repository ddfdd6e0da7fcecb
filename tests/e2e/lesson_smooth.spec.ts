import type { Page } from '@playwright/test';
import { sectionIds } from '../../web/src/notation/sections.ts';
import { mark, startTracing, stopTracing } from './support/main_thread.ts';
import { expect, openSection, test } from './support/page.ts';

test.use({ trace: 'off' }); // its snapshots are tasks of the page

/** Opens another section and scrolls through it, a few lines in every picture. One script, since what a test asks of a page is a task of it, too. */
async function readThrough(page: Page, section: string): Promise<void> {
  await page.evaluate(
    async ([id, name]) => {
      const nextPicture = () => new Promise(requestAnimationFrame);
      performance.mark(name);
      location.assign(`#/lesson/${id}`);
      while (!document.querySelector(`.contents a[href$="${id}"][aria-current]`)) await nextPicture();
      while (!document.querySelector('.sources')) await nextPicture(); // they come last
      const { scrollHeight, clientHeight } = document.documentElement;
      for (let top = 0; top < scrollHeight - clientHeight; top += 200) {
        scrollTo(0, top);
        await nextPicture();
      }
      performance.mark(name);
    },
    [section, mark],
  );
}

test('opening a section and scrolling through it never keeps the page from answering', async ({ page, browser }) => {
  await openSection(page, 'model');
  await readThrough(page, 'tasks'); // what every section needs is compiled
  for (const id of sectionIds) {
    await startTracing(browser, page);
    await readThrough(page, id);
    const tasks = await stopTracing(browser);
    expect(tasks.length).toBeGreaterThan(10);
    expect(Math.max(...tasks), id).toBeLessThan(50); // what is felt; the longest take half of it
  }
});
