import { defineConfig } from '@playwright/test';
import { findChromium } from '../../.scripts/find_command.mjs';

const port = Number(process.env.E2E_PORT ?? 4180);
const executablePath = findChromium();

export default defineConfig({
  testDir: '.',
  outputDir: '../../test-results',
  // Software rendering takes both cores of a small machine.
  workers: 1,
  timeout: 60_000,
  expect: { timeout: 20_000 },
  forbidOnly: true,
  // A browser on a machine shared with others may do things in an order that a test has not foreseen. What passes the
  // second time is listed as flaky, and is a mistake of the test to be mended.
  retries: 1,
  reporter: [['list']],
  use: {
    baseURL: `http://127.0.0.1:${port}/a/b/`,
    viewport: { width: 1280, height: 720 },
    trace: 'on-first-retry', // recording costs a sixth of the time; `--trace on` shows what any test did
    launchOptions: executablePath ? { executablePath } : {},
  },
  webServer: {
    command: `node --import tsx support/serve.ts ${port}`,
    url: `http://127.0.0.1:${port}/a/b/`,
  },
});
