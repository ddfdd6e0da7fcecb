import type { Plugin } from 'vite';
import { VitePWA } from 'vite-plugin-pwa';
import { defineConfig } from 'vitest/config';
import { contentSecurityPolicy } from './web/content_security_policy.ts';

/** Not while developing: the development server injects inline scripts. */
const policyInBuiltPage: Plugin = {
  name: 'content-security-policy',
  apply: 'build',
  transformIndexHtml: () => [
    {
      tag: 'meta',
      attrs: { 'http-equiv': 'Content-Security-Policy', content: contentSecurityPolicy },
      injectTo: 'head-prepend',
    },
  ],
};

const offline = VitePWA({
  registerType: 'prompt',
  injectRegister: false, // the page registers it, to be able to ask
  manifest: {
    name: 'Mass–Spring Lab',
    short_name: 'Springs',
    description: 'Fast simulation of mass-spring systems: the local projection and the global solve, side by side',
    background_color: '#ffffff',
    theme_color: '#ffffff',
    icons: [{ src: 'icon.svg', sizes: 'any', type: 'image/svg+xml' }],
  },
  workbox: {
    // Everything, scenes too: a classroom may have no network tomorrow.
    globPatterns: ['**/*'],
    // KaTeX names three formats of each font; browsers take the first, woff2.
    globIgnores: ['**/*.{woff,ttf}'],
    maximumFileSizeToCacheInBytes: 8 * 1024 * 1024,
  },
});

export default defineConfig({
  root: 'web',
  base: './',
  plugins: [policyInBuiltPage, offline],
  worker: { format: 'es' },
  server: { fs: { allow: ['..'] } }, // scenes/ and wasm/ lie beside web/
  preview: { headers: { 'Content-Security-Policy': contentSecurityPolicy } },
  build: {
    outDir: '../dist',
    emptyOutDir: true,
    target: 'es2022',
    assetsInlineLimit: 0,
    chunkSizeWarningLimit: Number.POSITIVE_INFINITY, // tests/e2e/budget.spec.ts limits what a visit loads
  },
  test: {
    root: '.',
    include: ['tests/**/*.test.{ts,tsx}'],
    coverage: { provider: 'v8', include: ['web/src/**'] },
  },
});
