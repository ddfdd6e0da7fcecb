import type { Page } from '@playwright/test';
import { expect, expectReady, open, test } from './support/page.ts';

const scenes = [
  'single-spring-horizontal',
  'triangle',
  'horizontal-chain',
  'patch',
  'net',
  'tower',
  'flag',
  'skirt',
  'cloth',
  'rabbit',
];

const status = (page: Page) => page.getByTestId('status');
const button = (page: Page, name: string | RegExp) => page.getByRole('button', { name, exact: true });

const sceneMenu = (page: Page) => page.getByRole('combobox', { name: /^Scene/ });

/** Opens a scene at rest, the clock standing at the first time step's predict. */
async function openPaused(page: Page, scene = 'net', more = ''): Promise<void> {
  await page.emulateMedia({ reducedMotion: 'reduce' }); // then the page does not begin to play by itself
  await open(page, `./#/springs?scene="${scene}"${more}`);
  await expect(status(page)).toContainText('time step t = 1 · iteration 0 of');
}

/** Where the vertex under the pin handle is drawn, in CSS pixels of the window. */
async function pinOnScreen(page: Page): Promise<{ x: number; y: number }> {
  const box = await page.locator('.pin-handle').boundingBox();
  if (!box) throw new Error('no pin is drawn');
  return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
}

/** m: the position of the chosen pin's target, from the words that a screen reader hears. */
async function pinTarget(page: Page): Promise<number[]> {
  const label = (await page.locator('.pin-handle').getAttribute('aria-label')) ?? '';
  return (label.match(/at (.*?) m\./)?.[1] ?? '').split(', ').map(Number);
}

for (const scene of scenes)
  test(`${scene} opens and takes a time step`, async ({ page }) => {
    await openPaused(page, scene);
    await button(page, 'One time step').click();
    await expect(status(page)).toContainText(/time step t = 1 · iteration (\d+) of \1 · accept/);
  });

test('opens moving, and the first thing it offers is to pause', async ({ page }) => {
  await open(page);
  await expect(status(page)).toContainText('playing');
  await button(page, 'Pause, look inside').click();
  await expect(status(page)).toContainText('iteration 1 of 50 · local');
});

test('walks one time step half-step by half-step, and back', async ({ page }) => {
  await openPaused(page);
  const forward = button(page, /^Half-step forward/);
  const places: string[] = [];
  for (const place of ['iteration 1 of 50 · local', 'iteration 1 of 50 · global', 'iteration 2 of 50 · local']) {
    await forward.click();
    await expect(status(page)).toContainText(place);
    places.push(place);
  }
  for (const place of places.slice(0, -1).reverse()) {
    await button(page, 'Half-step back').click();
    await expect(status(page)).toContainText(place);
  }
});

test('scrubs to any half-step of the time step', async ({ page }) => {
  await openPaused(page);
  const scrubber = page.getByRole('slider', { name: 'Half-step of this time step' });
  await scrubber.fill('41');
  await expect(status(page)).toContainText('iteration 21 of 50 · local');
  await scrubber.fill('0');
  await expect(status(page)).toContainText('iteration 0 of 50 · predict');
});

test('steps back across the beginning of a time step', async ({ page }) => {
  await openPaused(page);
  await button(page, 'One time step').click();
  await expect(status(page)).toContainText('t = 1 · iteration 50 of 50 · accept');
  await button(page, /^Half-step forward/).click();
  await expect(status(page)).toContainText('t = 2 · iteration 0 of 50 · predict');
  await button(page, 'Half-step back').click();
  await expect(status(page)).toContainText('t = 1 · iteration 50 of 50 · accept');
});

test('follows the keys of the course’s program', async ({ page }) => {
  await openPaused(page);
  await page.keyboard.press('Space');
  await expect(status(page)).toContainText('t = 1 · iteration 50 of 50 · accept');
  await page.keyboard.press('ArrowLeft');
  await expect(status(page)).toContainText('iteration 50 of 50 · global');
  await page.keyboard.press('w');
  await expect(page.getByLabel('Wind')).toBeChecked();
  await page.keyboard.press('l');
  await expect(page.getByLabel('Springs', { exact: true })).not.toBeChecked();
  await page.keyboard.press('a');
  await expect(status(page)).toContainText('playing');
  await page.keyboard.press('a');
  await page.keyboard.press('r');
  await expect(status(page)).toContainText('t = 1 · iteration 0 of 50 · predict');
  await page.keyboard.press('?');
  await expect(page.getByRole('complementary', { name: 'Help and keys' })).toBeVisible();
});

test('a pin dragged with the mouse takes the net along', async ({ page }) => {
  await openPaused(page);
  const before = await pinTarget(page);
  const { x, y } = await pinOnScreen(page);
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x - 60, y - 40, { steps: 5 });
  await page.mouse.up();
  await expect.poll(async () => (await pinTarget(page))[0]).toBeLessThan(before[0] - 0.01);
  expect((await pinTarget(page))[1]).toBeGreaterThan(before[1] + 0.01);
  await button(page, 'One time step').click();
  // the handle stands where the vertex itself is drawn, not its target: it has followed
  await expect.poll(async () => Math.round((await pinOnScreen(page)).x)).toBe(Math.round(x - 60));
});

test('a focused pin moves with the arrow keys, without refactorising', async ({ page }) => {
  await openPaused(page);
  const before = await pinTarget(page);
  await page.locator('.pin-handle').focus();
  for (let press = 0; press < 3; press++) await page.keyboard.press('Shift+ArrowRight');
  await expect.poll(async () => (await pinTarget(page))[0]).toBeGreaterThan(before[0] + 0.05);
  await expect(page.getByTestId('factorisations')).toContainText('1 time · last because the scene was opened');
  await expect(status(page)).toContainText('predict'); // the arrows moved the pin, not the time
  const { x } = await pinOnScreen(page);
  await button(page, 'One time step').click();
  await expect.poll(async () => (await pinOnScreen(page)).x).toBeGreaterThan(x + 5); // the vertex has followed
});

test('w changes from pins held exactly to the penalty, and back', async ({ page }) => {
  await openPaused(page);
  const held = page.getByTestId('pins-held');
  await expect(held).toContainText('exactly');
  await page.getByRole('textbox', { name: 'pin penalty' }).fill('1e4');
  await page.keyboard.press('Enter');
  await expect(held).toContainText('penalty w');
  await page.getByRole('button', { name: 'w: Back to the scene’s value' }).click();
  await expect(held).toContainText('exactly');
});

test('the scene chosen last is the one that opens, however slowly the one before comes', async ({ page }) => {
  await openPaused(page);
  await page.route('**/skirt*.obj', () => {}); // never answered
  await sceneMenu(page).selectOption('skirt');
  await sceneMenu(page).selectOption('tower');
  await expect(page.getByText('209 vertices')).toBeVisible();
  await expect(sceneMenu(page)).toHaveValue('tower');
});

test('skipping to the transport keeps everything as it is', async ({ page }) => {
  await openPaused(page, 'tower', '&parameters={"k":777}');
  await page.keyboard.press('Tab');
  await page.keyboard.press('Enter');
  await expect(page.locator('#transport')).toBeFocused();
  await expect(sceneMenu(page)).toHaveValue('tower');
  await expect(page.getByRole('textbox', { name: 'stiffness' })).toHaveValue('777');
});

test('says when Q was factorised anew, and why', async ({ page }) => {
  await openPaused(page);
  const factorisations = page.getByTestId('factorisations');
  await page.getByRole('textbox', { name: 'stiffness' }).fill('500');
  await page.keyboard.press('Enter');
  await expect(factorisations).toContainText('2 times · last because k changed');
  await page.getByRole('button', { name: /^(Pin|Free) this vertex$/ }).click();
  await expect(factorisations).toContainText('3 times · last because the set of pins changed');
});

test('reads fractions, and answers what it cannot read with a sentence', async ({ page }) => {
  await openPaused(page);
  const field = page.getByRole('textbox', { name: 'Δt time step' });
  await field.fill('1/60');
  await field.press('Enter');
  await expect(field).toHaveValue('0.01667');
  await field.fill('soon');
  await field.press('Enter');
  await expect(page.getByText('“soon” is not a number')).toBeVisible();
  await button(page, /^Half-step forward/).click();
  await expect(status(page)).toContainText('local');
});

test('the address carries scene, language, parameters and pins', async ({ page, context }) => {
  await openPaused(page);
  await page.getByRole('textbox', { name: 'stiffness' }).fill('777');
  await page.keyboard.press('Enter');
  await page.locator('.pin-handle').focus();
  await page.keyboard.press('ArrowUp');
  await button(page, '切换到简体中文').click();
  await expect(page).toHaveURL(/777.*pins.*zh/);
  const target = (await page.locator('.pin-handle').getAttribute('aria-label')) as string;

  const second = await context.newPage();
  await second.emulateMedia({ reducedMotion: 'reduce' });
  await second.goto(page.url());
  await expectReady(second);
  await expect(second.getByRole('textbox', { name: '弹簧刚度' })).toHaveValue('777');
  await expect(second.locator('.pin-handle')).toHaveAttribute('aria-label', target);
});

test('a malformed link opens the default and says so', async ({ page }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await open(page, './#/springs?scene="nowhere"&parameters={"k":-3}');
  await expect(page.getByText('There is no scene “nowhere”')).toBeVisible();
  await expect(page.getByText('The link’s part parameters = {"k":-3}')).toBeVisible();
  await expect(sceneMenu(page)).toHaveValue('net');
});

test('speaks Chinese', async ({ page }) => {
  await openPaused(page);
  await button(page, '切换到简体中文').click();
  await expect(page.getByRole('heading', { level: 1 })).toHaveText('质点弹簧实验室');
  await expect(status(page)).toContainText('第 0 次迭代（共 50 次）· 预测');
  await expect(page.locator('html')).toHaveAttribute('lang', 'zh-Hans');
});

test('opens the reader’s own files, and explains a broken one', async ({ page }) => {
  await openPaused(page);
  const choose = page.locator('input[type="file"]');
  const file = (name: string, text: string) => ({ name, mimeType: 'text/plain', buffer: Buffer.from(text) });
  const obj = file('pair.obj', 'v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2\nf 2 3\n');
  await choose.setInputFiles([file('pair.json', '{"obj":"pair.obj","b":[1],"k":100,"m":1}'), obj]);
  await expect(sceneMenu(page)).toHaveValue('pair');
  await choose.setInputFiles([file('bad.json', '{"obj":"pair.obj","b":[7],"k":100,"m":1}'), obj]);
  await expect(page.getByText('bad.json b[0]: vertex 7 of 3')).toBeVisible();
  await expect(sceneMenu(page)).toHaveValue('pair');
});

test('opens a mesh that has no JSON, and explains a broken one', async ({ page }) => {
  await openPaused(page);
  const choose = page.locator('input[type="file"]');
  const file = (name: string, text: string) => ({ name, mimeType: 'text/plain', buffer: Buffer.from(text) });
  const block =
    'MeshVersionFormatted 2 Dimension 3\nVertices 4\n0 0 0 0\n1 0 0 0\n0 0 1 0\n0 1 0 0\nTetrahedra 1\n1 2 3 4 0\nEnd\n';
  await choose.setInputFiles([file('block.mesh', block)]);
  await expect(sceneMenu(page)).toHaveValue('block');
  await expect(page.getByText('4 vertices, 6 springs').first()).toBeVisible();
  await choose.setInputFiles([file('short.mesh', block.replace('Tetrahedra 1', 'Tetrahedra 2'))]);
  await expect(page.getByText('short.mesh line 9: Tetrahedra ends after 1 of 2 rows')).toBeVisible();
  await expect(sceneMenu(page)).toHaveValue('block');
});
