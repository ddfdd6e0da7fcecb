// `node wasm/build.mjs web` builds build/web/solver.js and solver.wasm; `node wasm/build.mjs native` builds the core's
// own tests in build/native. Silent when nothing is to be done.
import { spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
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

/** False too for a build folder that was copied or moved along with the sources: it would build the old place's. */
function isConfiguredHere() {
  const cache = join(build, 'CMakeCache.txt');
  if (!existsSync(join(build, 'build.ninja')) || !existsSync(cache)) return false;
  if (readFileSync(cache, 'utf8').includes(`CMAKE_HOME_DIRECTORY:INTERNAL=${source}\n`)) return true;
  for (const name of readdirSync(build)) {
    if (name !== 'lock') rmSync(join(build, name), { recursive: true });
  }
  return false;
}

/** @param {string[]} command */
function run([program, ...args]) {
  const { status, stdout, stderr, error } = spawnSync(program, args, { env, encoding: 'utf8' });
  if (status !== 0) {
    console.error(error ? `${program}: ${error.message}` : `${stdout}${stderr}`);
    process.exit(1);
  }
  return stdout;
}

/**
 * One build at a time: two that link at once leave a solver.js that does not fit its solver.wasm.
 *
 * @param {string} lock a file with the process number of who builds
 */
function takeTurn(lock) {
  const isFree = () => {
    try {
      process.kill(Number(readFileSync(lock, 'utf8')), 0); // only asks whether it runs
      return false;
    } catch {
      return true;
    }
  };
  for (;;) {
    try {
      writeFileSync(lock, `${process.pid}`, { flag: 'wx' });
      break;
    } catch {
      if (isFree()) rmSync(lock, { force: true });
      else Atomics.wait(new Int32Array(new SharedArrayBuffer(4)), 0, 0, 100); // ms
    }
  }
  process.on('exit', () => rmSync(lock, { force: true }));
}

mkdirSync(build, { recursive: true });
takeTurn(join(build, 'lock'));
if (!isConfiguredHere()) run([...configure[target], '-S', source, '-B', build, '-G', 'Ninja']);
const lines = run(['ninja', '--quiet', '-C', build]).split('\n');
// What remains are the compilers' warnings.
const warnings = lines.filter((line) => line && !line.startsWith('ninja: ') && !line.startsWith('-- '));
if (warnings.length > 0) console.error(warnings.join('\n'));
