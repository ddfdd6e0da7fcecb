import { expect, test } from '@playwright/test';
import { expectReady } from './support/page.ts';

// These pages are made to fail, so Playwright's own page is used: the browser itself complains on the console.

test.use({ reducedMotion: 'reduce' } as object);

test('without WebGL the page says so', async ({ page }) => {
  await page.addInitScript(() => {
    HTMLCanvasElement.prototype.getContext = () => null;
  });
  await page.goto('./');
  await expect(page.getByRole('alert')).toContainText('WebGL 2');
});

test('without WebAssembly the page says so', async ({ page }) => {
  await page.addInitScript(() => {
    Reflect.deleteProperty(globalThis, 'WebAssembly');
  });
  await page.goto('./');
  await expect(page.getByRole('alert')).toContainText('WebAssembly');
});

test('without the solver’s file the page names it', async ({ page }) => {
  await page.route('**/*.wasm', (route) => route.fulfill({ status: 404 }));
  await page.goto('./');
  await expect(page.getByRole('alert')).toContainText(/solver.*\.wasm.*HTTP 404/);
});

test('without the solver’s file the lesson can be read, and its figures name it', async ({ page }) => {
  await page.route('**/*.wasm', (route) => route.fulfill({ status: 404 }));
  await page.goto('./#/lesson/trick');
  await expect(page.getByText('The trick does not remove the length.')).toBeVisible();
  await page.locator('.figure').first().scrollIntoViewIfNeeded();
  await expect(page.getByRole('alert').first()).toContainText(/solver.*\.wasm.*HTTP 404/);
});

test('with a broken solver the page says that it did not start', async ({ page }) => {
  await page.route('**/*.wasm', (route) => route.fulfill({ body: 'not a module', contentType: 'application/wasm' }));
  await page.goto('./');
  await expect(page.getByRole('alert')).toContainText('The solver did not start');
});

test('a solver that crashes is replaced, and the last good state is back', async ({ page }) => {
  await page.goto('./#/springs?scene="net"');
  await expectReady(page);
  const status = page.getByTestId('status');
  await page.getByRole('button', { name: 'Play' }).click();
  await expect(status).toContainText(/t = ([2-9]|\d\d+) · playing/); // some steps have been finished
  const [worker] = page.workers();
  await worker.evaluate(() => {
    setInterval(() => {
      throw new Error('trapped on purpose');
    }, 1);
  });
  await expect(page.getByText('It was replaced and the last good state restored')).toBeVisible();
  await expect(status).toContainText('accept'); // the clock has stopped at the last step that was finished
  const step = Number((await status.textContent())?.match(/t = (\d+)/)?.[1]);
  await page.getByRole('button', { name: 'One time step' }).click();
  await expect(status).toContainText(`t = ${step + 1} · iteration 50`);
});

test('without its worker the order of accuracy says so, and is measured once there is one', async ({ page }) => {
  const script = /\/timing_worker/;
  await page.route(script, (route) => route.abort());
  await page.goto('./#/integrators');
  await expectReady(page);
  const order = page.locator('#order');
  await order.scrollIntoViewIfNeeded();
  await expect(order.getByRole('alert')).toContainText('timing_worker');
  await page.unroute(script);
  await order.getByRole('alert').getByRole('button').click();
  await expect(order).toHaveAttribute('data-measured', 'true', { timeout: 60_000 });
});
