import { test as base, expect, type Page } from '@playwright/test';

/** Collects what a healthy page never does. Violations of the content security policy show as errors on the console. */
function watch(page: Page, home: string): string[] {
  const complaints: string[] = [];
  page.on('console', (message) => {
    if (message.type() === 'error') complaints.push(`console: ${message.text()} (${message.location().url})`);
  });
  page.on('pageerror', (error) => complaints.push(`uncaught: ${error.stack ?? error.message}`));
  page.context().on('request', (request) => {
    if (/^(http|ws)/.test(request.url()) && !request.url().startsWith(home))
      complaints.push(`request outside ${home}: ${request.url()}`);
  });
  return complaints;
}

/** Playwright's test, with a page that must behave. */
export const test = base.extend({
  page: async ({ page, baseURL }, use) => {
    const complaints = watch(page, `${baseURL}`);
    await use(page);
    expect(complaints, 'what the page did wrong').toEqual([]);
  },
});

/** Opens the app, at its own address followed by `rest`, and waits for the first frame. */
export async function open(page: Page, rest = './'): Promise<void> {
  await page.goto(rest);
  await expectReady(page);
}

/** Opens a section of the lesson and waits until all of it is there; `rest`: what the address says besides. */
export async function openSection(page: Page, id: string, rest = ''): Promise<void> {
  await open(page, `./#/lesson/${id}${rest}`);
  await expect(page.locator('.sources')).toBeVisible(); // a section comes in slices, and they come last
}

/** The app has drawn its first frame. */
export async function expectReady(page: Page): Promise<void> {
  await expect(page.locator('body')).toHaveAttribute('data-ready', 'true');
}

export { expect };
