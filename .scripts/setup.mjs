// `node .scripts/setup.mjs packages|build|bench|test` installs what that purpose lacks, and is silent when nothing does.
// Plain Node, because it runs before the npm packages are there; prints to stderr only, because `npm run simulate` prints data.
import { spawnSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { findChromium, findCommand } from './find_command.mjs';

process.chdir(`${import.meta.dirname}/..`);

/**
 * What npm cannot install.
 *
 * @typedef {object} Requirement
 * @property {string} name
 * @property {string[]} apt Debian's packages
 * @property {string[]} brew Homebrew's; none where macOS has its own
 * @property {() => unknown} isPresent
 */

/** @param {string} file */
const hasHeader = (file) =>
  ['/usr/include', '/usr/local/include', '/opt/homebrew/include'].some((folder) => existsSync(`${folder}/${file}`));

/** @type {Record<string, Requirement>} */
const requirements = {
  emscripten: {
    name: 'Emscripten',
    apt: ['emscripten'],
    brew: ['emscripten'],
    isPresent: () => findCommand('em++'),
  },
  cmake: { name: 'CMake', apt: ['cmake'], brew: ['cmake'], isPresent: () => findCommand('cmake') },
  ninja: { name: 'Ninja', apt: ['ninja-build'], brew: ['ninja'], isPresent: () => findCommand('ninja') },
  eigen: { name: 'Eigen', apt: ['libeigen3-dev'], brew: ['eigen'], isPresent: () => hasHeader('eigen3/Eigen/Core') },
  compiler: { name: 'a C++ compiler', apt: ['g++'], brew: [], isPresent: () => findCommand('c++') },
  doctest: {
    name: 'doctest',
    apt: ['doctest-dev'],
    brew: ['doctest'],
    isPresent: () => hasHeader('doctest/doctest.h'),
  },
  chromium: {
    name: 'Chromium',
    // With fonts that have the page's Latin and Chinese characters.
    apt: ['chromium', 'fonts-noto-cjk', 'fonts-dejavu-core'],
    brew: [],
    isPresent: findChromium,
  },
};

const { emscripten, cmake, ninja, eigen, compiler, doctest, chromium } = requirements;
const isDebian = existsSync('/etc/os-release') && /^ID=debian$/m.test(readFileSync('/etc/os-release', 'utf8'));
const build = [emscripten, cmake, ninja, eigen];
const bench = [...build, compiler];
// Other systems' packages of this name may be empty: there the browser is Playwright's own.
const test = [...bench, doctest, ...(isDebian ? [chromium] : [])];
/** @type {Record<string, Requirement[]>} */
const purposes = { packages: [], build, bench, test };

/**
 * @param {string} message
 * @returns {never}
 */
function fail(message) {
  console.error(`Set-up: ${message}`);
  process.exit(1);
}

/** @param {string[]} command */
const succeeds = ([program, ...args]) => spawnSync(program, args).status === 0;

/**
 * @param {string} doing what to tell the user meanwhile
 * @param {string[][]} commands
 */
function run(doing, ...commands) {
  console.error(`Set-up: ${doing} …`);
  for (const [program, ...args] of commands) {
    const { status, stdout, stderr } = spawnSync(program, args, { encoding: 'utf8', maxBuffer: 2 ** 27 });
    if (status === 0) continue;
    const lastLines = `${stdout}${stderr}`.trim().split('\n').slice(-20).join('\n');
    fail(`this command failed:\n${[program, ...args].join(' ')}\n${lastLines}`);
  }
}

/** @param {Requirement[]} missing */
function installFromSystem(missing) {
  const names = missing.map(({ name }) => name).join(', ');
  const apt = missing.flatMap((requirement) => requirement.apt);
  const brew = missing.flatMap((requirement) => requirement.brew);
  const asRoot = process.getuid?.() === 0 ? ['env'] : ['sudo', '-n', 'env'];
  if (findCommand('apt-get') && succeeds([...asRoot, 'true'])) {
    const aptGet = [...asRoot, 'DEBIAN_FRONTEND=noninteractive', 'apt-get', '-qq', '-o', 'DPkg::Lock::Timeout=300'];
    run(
      `installing ${names} with apt`,
      [...aptGet, 'update'],
      [...aptGet, 'install', '--yes', '--no-install-recommends', ...apt],
    );
  } else if (findCommand('brew') && brew.length > 0) {
    run(`installing ${names} with Homebrew`, ['brew', 'install', ...brew]);
  }
  const absent = missing.filter((requirement) => !requirement.isPresent());
  if (absent.length > 0)
    fail(
      `please install ${absent.map(({ name, apt }) => `${name} (Debian: ${apt.join(' ')})`).join(', ')}, then run this again.`,
    );
}

function installPackages() {
  const lockHash = createHash('sha256').update(readFileSync('package-lock.json')).digest('hex');
  const stamp = 'node_modules/.lock-hash';
  if (existsSync(stamp) && readFileSync(stamp, 'utf8') === lockHash) return;
  const quietly = ['--no-audit', '--no-fund', '--loglevel=error'];
  run('installing the npm packages', ['npm', 'ci', '--include=dev', ...quietly]);
  writeFileSync(stamp, lockHash);
}

async function installBrowser() {
  if (findChromium()) return;
  const playwright = await import('@playwright/test');
  if (existsSync(playwright.chromium.executablePath())) return;
  run("installing Playwright's Chromium", ['npx', 'playwright', 'install', 'chromium']);
}

const [major, minor] = process.versions.node.split('.').map(Number);
if (major < 20 || (major === 20 && minor < 19)) fail(`Node is ${process.version}; please install 20.19 or newer.`);

const purpose = process.argv[2];
if (!(purpose in purposes)) fail(`for which purpose? One of ${Object.keys(purposes).join(', ')}.`);

const missing = purposes[purpose].filter((requirement) => !requirement.isPresent());
if (missing.length > 0) installFromSystem(missing);
installPackages();
if (purpose === 'test') await installBrowser();
