// `serve.ts PORT` serves dist/ as a strict static host would: under the sub-path /a/b/, and with the page's policy as a header.
import { readFile } from 'node:fs/promises';
import { createServer } from 'node:http';
import { extname, join } from 'node:path';
import { contentSecurityPolicy } from '../../../web/content_security_policy.ts';

const dist = join(import.meta.dirname, '../../../dist');
const subPath = '/a/b/';
const contentTypes: Record<string, string> = {
  '.css': 'text/css',
  '.html': 'text/html; charset=utf-8',
  '.js': 'text/javascript',
  '.json': 'application/json',
  '.png': 'image/png',
  '.svg': 'image/svg+xml',
  '.wasm': 'application/wasm',
  '.webmanifest': 'application/manifest+json',
  '.woff2': 'font/woff2',
};

const server = createServer(async ({ url = '/' }, response) => {
  const { pathname } = new URL(url, 'http://localhost');
  const file = pathname.slice(subPath.length) || 'index.html';
  const body = pathname.startsWith(subPath) ? await readFile(join(dist, file)).catch(() => undefined) : undefined;
  if (!body) {
    response.writeHead(404).end();
    return;
  }
  response.setHeader('Content-Type', contentTypes[extname(file)] ?? 'application/octet-stream');
  response.setHeader('Content-Security-Policy', contentSecurityPolicy);
  response.end(body);
});
server.listen(Number(process.argv[2]), '127.0.0.1');
