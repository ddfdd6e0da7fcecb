/** What the page may load and run: only its own files. Static hosts send no headers of ours, so the built page carries it itself. */
export const contentSecurityPolicy = [
  "default-src 'self'",
  "script-src 'self' 'wasm-unsafe-eval'",
  "style-src 'self' 'unsafe-inline'", // KaTeX places its boxes by style attributes
  "connect-src 'self' blob:", // blob: scenes that the user opens, read in a worker
  "img-src 'self' data: blob:", // blob: their pictures; data: cursors and masks in styles
  "object-src 'none'",
  "base-uri 'none'",
  "form-action 'none'",
].join('; ');
