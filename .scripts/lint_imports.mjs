// Proves that the imports in web/src go one way (docs/decisions/0202-import-direction.md says why not by Biome).
import { readdirSync, readFileSync } from 'node:fs';
import { dirname, join, sep } from 'node:path';
import ts from 'typescript';

/** A layer may import the layers of earlier rows; layers of one row do not know each other. */
const order = [['lib'], ['notation', 'scene', 'curves'], ['solver'], ['app'], ['views'], ['labs'], ['main']];
/** Layers whose folders do not know each other either. */
const divided = ['views', 'labs'];
/** What may be imported in one folder only. */
const homes = Object.entries({
  three: 'views/scene3d',
  katex: 'views/equations',
  uplot: 'views/plots',
  'ohm-js': 'curves',
  svgpath: 'curves',
  '#wasm/solver.js': 'solver',
});

/** @param {string} file relative to web/src */
function place(file) {
  const [layer, part] = file.replace(/\.tsx?$/, '').split('/');
  return {
    row: order.findIndex((row) => row.includes(layer)),
    name: divided.includes(layer) ? `${layer}/${part}` : layer,
  };
}

/**
 * @param {string} importer relative to web/src
 * @param {string} specifier what it imports
 * @returns {string | undefined} what is wrong about it
 */
function violation(importer, specifier) {
  const [, home] = homes.find(([name]) => specifier === name || specifier.startsWith(`${name}/`)) ?? [];
  if (home) return importer.startsWith(`${home}/`) ? undefined : `belongs to ${home} alone`;
  const imported = join(dirname(importer), specifier).split(sep).join('/');
  if (!specifier.startsWith('.') || imported.startsWith('..')) return undefined; // a package, or data outside the sources
  const from = place(importer);
  const to = place(imported);
  if (!/\.tsx?$/.test(specifier)) return undefined; // a style sheet
  if (from.row < 0 || to.row < 0) return 'belongs to no layer';
  return from.name === to.name || to.row < from.row ? undefined : `${from.name} may not import ${to.name}`;
}

const sources = join(import.meta.dirname, '../web/src');
const files = readdirSync(sources, { recursive: true, encoding: 'utf8' }).filter((file) => /\.tsx?$/.test(file));
const complaints = files.flatMap((file) =>
  ts.preProcessFile(readFileSync(join(sources, file), 'utf8')).importedFiles.flatMap(({ fileName }) => {
    const wrong = violation(file.split(sep).join('/'), fileName);
    return wrong ? [`web/src/${file}: import '${fileName}': ${wrong}`] : [];
  }),
);
for (const complaint of complaints) console.error(complaint);
process.exit(complaints.length > 0 ? 1 : 0);
