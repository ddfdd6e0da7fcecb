import { expect, openSection, test } from './support/page.ts';

test('the help says what can be done on the page that is open', async ({ page }) => {
  await openSection(page, 'model');
  await page.keyboard.press('?');
  const help = page.locator('.help');
  await expect(help).toContainText('drag a vertex: pull at it');
  await expect(help).not.toContainText('wind on or off'); // a key of the lab alone
  await page.keyboard.press('Escape');
  await expect(help).toBeHidden();
  await page.getByRole('link', { name: 'Springs', exact: true }).click();
  await page.keyboard.press('?');
  await expect(help).toContainText('wind on or off');
});
