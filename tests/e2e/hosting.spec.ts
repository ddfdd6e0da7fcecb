import { contentSecurityPolicy } from '../../web/content_security_policy.ts';
import { expect, open, test } from './support/page.ts';

// That the app works under a sub-path and asks for nothing outside it is checked in every test (support/page.ts).

test('the page carries its own content security policy', async ({ page }) => {
  await open(page);
  const policy = page.locator('meta[http-equiv="Content-Security-Policy"]');
  await expect(policy).toHaveAttribute('content', contentSecurityPolicy);
});
