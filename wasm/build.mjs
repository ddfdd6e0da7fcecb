// `node wasm/build.mjs web` builds build/web/solver.js and solver.wasm; `node wasm/build.mjs native` builds the core's
// own tests in build/native. Silent when nothing is to be done.
import { spawnSync } from 'node:child_process';
import { existsSync } from 'node:fs';
import { join } from 'node:path';

const source = import.meta.dirname;
const target = process.argv[2];
/** @type {Record<string, string[]>} what configures each target */
const configure = { web: ['emcmake', 'cmake'], native: ['cmake'] };
if (!(target in configure)) {
  console.error(`Build what? One of ${Object.keys(configure).join(', ')}.`);
  process.exit(2);
}
const build = join(source, 'build', target);

// Debian's Emscripten needs acorn, which its package put where only Debian's own Node looks.
const debianModules = '/usr/share/nodejs';
const nodePath = [process.env.NODE_PATH, existsSync(debianModules) ? debianModules : undefined].filter(Boolean);
const env = { ...process.env, NODE_PATH: nodePath.join(':') };

/**
 * @param {string[]} command
 * @param {import('node:child_process').StdioOptions} output
 */
function run([program, ...args], output) {
  const { status, stdout, stderr, error } = spawnSync(program, args, { env, stdio: output, encoding: 'utf8' });
  if (status === 0) return;
  console.error(error ? `${program}: ${error.message}` : `${stdout ?? ''}${stderr ?? ''}`);
  process.exit(1);
}

if (!existsSync(join(build, 'build.ninja')))
  run([...configure[target], '-S', source, '-B', build, '-G', 'Ninja'], 'pipe');
// Quiet about itself; what the compilers say is shown.
run(['ninja', '--quiet', '-C', build], 'inherit');
