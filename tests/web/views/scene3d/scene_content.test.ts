import type { DataTexture } from 'three';
import { expect, it } from 'vitest';
import { createInk } from '../../../../web/src/views/scene3d/ink.ts';
import { lightPalette } from '../../../../web/src/views/scene3d/palette.ts';
import { SceneContent } from '../../../../web/src/views/scene3d/scene_content.ts';
import { stageOf } from '../../../../web/src/views/scene3d/stages.ts';
import type { Scene3DFrame, Scene3DOptions } from '../../../../web/src/views/scene3d/types.ts';

/** A chain of springs of 1 m along x, its first vertex pinned. */
const springCount = 3000;
const vertexCount = springCount + 1;
const V = Float64Array.from({ length: 3 * vertexCount }, (_, at) => (at % 3 === 0 ? at / 3 : 0));
const E = Int32Array.from({ length: 2 * springCount }, (_, at) => Math.ceil(at / 2));
const model = { V, E, F: new Uint32Array(), texture: null, r: new Float64Array(springCount).fill(1) };

const options: Scene3DOptions = {
  exaggeration: 'automatic',
  strainRange: 'automatic',
  showSprings: true,
  showSurface: true,
  selected: { spring: 7, vertex: 7 },
  pointedAt: { spring: null, vertex: null },
  lit: { localSprings: false, globalSprings: false, vertices: false },
  palette: lightPalette,
};

function played(): Scene3DFrame {
  const d = Float64Array.from({ length: 3 * springCount }, (_, at) => (at % 3 === 0 ? -1 : 0));
  const [pinned, targets] = [Int32Array.of(0), new Float64Array(3)];
  return { phase: 'accept', p: V, pBefore: V, d, prediction: V, pinned, targets };
}

/** Draws pictures without a graphics card: `draw` returns how many numbers of tables it would send to one. */
function fakePictures() {
  const content = new SceneContent(createInk(), model, () => {});
  const sent = new Map<DataTexture, number>();
  return (frame: Scene3DFrame, stage = stageOf(frame, 1), marked: Partial<Scene3DOptions> = {}) => {
    content.refresh({ frame, stage }, { ...options, ...marked }, 100);
    const changed = new Set<DataTexture>();
    for (const { scene } of Object.values(content.views)) {
      scene.traverseVisible((object) => {
        const uniforms = 'material' in object ? (object.material as { uniforms: object }).uniforms : {};
        for (const { value } of Object.values(uniforms)) {
          if (value?.isDataTexture && sent.get(value) !== value.version) changed.add(value);
        }
      });
    }
    let numbers = 0;
    for (const texture of changed) {
      sent.set(texture, texture.version);
      numbers += (texture.image.data as Float32Array).length;
    }
    return numbers;
  };
}

it('a played frame sends the points of each view, the pieces of the springs, the pins, and nothing else', () => {
  const draw = fakePictures();
  draw(played());
  const lines = (rows: number) => 1024 * Math.ceil(rows / 1024);
  const pins = 2 * 1024 + 3 * 1024;
  expect(draw(played())).toBe(2 * 3 * lines(vertexCount) + 4 * lines(springCount) + pins);
});

it('drawing the same frame again sends nothing, whatever is marked in it', () => {
  const draw = fakePictures();
  const frame = played();
  const stage = stageOf(frame, 1);
  draw(frame, stage);
  expect(draw(frame, stage)).toBe(0);
  expect(draw(frame, stage, { pointedAt: { spring: 12, vertex: null } })).toBe(0);
  expect(draw(frame, stage, { lit: { localSprings: true, globalSprings: true, vertices: true } })).toBe(0);
});
