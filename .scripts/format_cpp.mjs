// Formats the C++ sources; with --check only complains about what is not formatted.
import { spawnSync } from 'node:child_process';
import { readdirSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';

const files = ['wasm', 'tests'].flatMap((folder) =>
  readdirSync(folder, { recursive: true, encoding: 'utf8' })
    .filter((file) => /\.(h|cpp)$/.test(file) && !/\bbuild\b/.test(file))
    .map((file) => join(folder, file)),
);
const clangFormat = createRequire(import.meta.url).resolve('@wasm-fmt/clang-format/clang-format-cli.cjs');
const mode = process.argv.includes('--check') ? ['--dry-run', '--Werror'] : ['-i'];
const { status } = spawnSync(process.execPath, [clangFormat, ...mode, ...files], { stdio: 'inherit' });
process.exit(status ?? 1);
