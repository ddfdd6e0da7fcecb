import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { comparedLimits, type IntegratorsSettings, mostMethods } from '../../../web/src/app/integrators.ts';
import { type KinematicsSettings, kinematicsLimits } from '../../../web/src/app/kinematics.ts';
import { limits } from '../../../web/src/app/limits.ts';
import { decodeLink, encodeLink, longestLink } from '../../../web/src/app/link.ts';
import { pathOf, readPath, rooms } from '../../../web/src/app/route.ts';
import { type AppState, defaultState } from '../../../web/src/app/state.ts';
import { samplings } from '../../../web/src/curves/sampling.ts';
import { ikMethods } from '../../../web/src/solver/inverse_kinematics.ts';
import { methods, minimisers } from '../../../web/src/solver/module.ts';

const lab = { page: 'springs', room: null } as const;

const inside = ({ min, max }: { min: number; max: number }) => fc.double({ min, max, noNaN: true });
const point = fc.tuple(coordinate(), coordinate(), coordinate());

function coordinate() {
  return fc.double({ min: -1e3, max: 1e3, noNaN: true }).map((x) => x + 0); // JSON has no −0
}

/** Never both stopping rules. */
const stoppingRules = fc.oneof(
  fc.constant({}),
  fc.record({ stop_gradient: inside(limits.stop_gradient) }),
  fc.record({ stop_decrease: inside(limits.stop_decrease) }),
);

const states: fc.Arbitrary<AppState> = fc.record({
  version: fc.constant(1 as const),
  scene: fc.stringMatching(/^[\w-]{1,64}$/),
  parameters: fc
    .tuple(
      fc.record(
        {
          k: inside(limits.k),
          delta_t: inside(limits.delta_t),
          mass_scale: inside(limits.mass_scale),
          w: inside(limits.w),
          iterations: fc.integer(limits.iterations),
          wind: fc.boolean(),
          method: fc.constantFrom(...minimisers),
        },
        { requiredKeys: [] },
      ),
      stoppingRules,
    )
    .map(([scaled, rule]) => ({ ...scaled, ...rule })),
  pins: fc.option(fc.array(fc.record({ vertex: fc.nat(9999), target: fc.option(point) }), { maxLength: 20 })),
  selection: fc.record({ spring: fc.option(fc.nat(9999)), vertex: fc.option(fc.nat(9999)) }),
  view: fc.record({
    exaggeration: fc.oneof(fc.constant('automatic' as const), fc.integer({ min: 1, max: 1000 })),
    springs: fc.boolean(),
    surface: fc.boolean(),
    projector: fc.boolean(),
    plot: fc.constantFrom('trace' as const, 'comparison' as const),
    camera: fc.option(
      fc.record({ position: point, target: point }).filter(({ position, target }) => `${position}` !== `${target}`),
    ),
  }),
  integrators: fc.constant(defaultState.integrators), // which links to the springs do not carry
  kinematics: fc.constant(defaultState.kinematics), // likewise
  language: fc.constantFrom('en' as const, 'zh' as const),
  theme: fc.constantFrom('light' as const, 'dark' as const, 'system' as const),
});

const place = fc.tuple(...Array.from({ length: 3 }, () => inside(kinematicsLimits.coordinate).map((x) => x + 0)));
const planar = fc.tuple(coordinate(), coordinate()).map(([x, y]): [number, number] => [x / 100 + 0, y / 100 + 0]);
const text = (maxLength: number) => fc.string({ unit: 'binary', maxLength: maxLength / 2 });

const arms: fc.Arbitrary<KinematicsSettings> = fc.record({
  links: fc.array(
    fc.record({
      length: inside(kinematicsLimits.length),
      bend: fc.option(inside(kinematicsLimits.bend).map((angle) => angle + 0)),
    }),
    { minLength: 1, maxLength: kinematicsLimits.links.max },
  ),
  root: place as fc.Arbitrary<[number, number, number]>,
  mode: fc.constantFrom('aim' as const, 'draw' as const),
  target: place as fc.Arbitrary<[number, number, number]>,
  curve: fc.oneof(
    fc.record({ kind: fc.constantFrom('circle' as const, 'square' as const, 'heart' as const, 'star' as const) }),
    fc.record({ kind: fc.constant('letters' as const), text: text(kinematicsLimits.letters) }),
    fc.record({ kind: fc.constant('formula' as const), x: text(20), y: text(20), from: text(20), to: text(20) }),
    fc.record({ kind: fc.constant('hand' as const), strokes: fc.array(fc.array(planar, { maxLength: 9 })) }),
    fc.record({ kind: fc.constant('path' as const), d: text(100) }),
  ),
  sampling: fc.constantFrom(...samplings),
  points: fc.integer(kinematicsLimits.points),
  method: fc.constantFrom(...ikMethods),
  precision: fc.constantFrom('double' as const, 'single' as const),
  iterations: fc.integer(kinematicsLimits.iterations),
  epsilon: inside(kinematicsLimits.epsilon),
  turn: fc.option(inside(kinematicsLimits.turn)),
});

const comparisons: fc.Arbitrary<IntegratorsSettings> = fc.record({
  scene: fc.stringMatching(/^[\w-]{1,64}$/),
  methods: fc.array(
    fc.record({
      method: fc.constantFrom(...methods),
      iterations: fc.integer(comparedLimits.iterations),
      substeps: fc.integer(comparedLimits.substeps),
    }),
    { minLength: 1, maxLength: mostMethods },
  ),
  parameters: fc.record(
    {
      k: inside(comparedLimits.k),
      mass_scale: inside(comparedLimits.mass_scale),
      delta_t: inside(comparedLimits.delta_t),
      damping: inside(comparedLimits.damping).map((c) => c + 0), // JSON has no −0
      gravity: inside(comparedLimits.gravity).map((g) => g + 0),
    },
    { requiredKeys: [] },
  ),
  poke: fc.record({
    stiffness: fc.option(inside(comparedLimits.poke.stiffness)),
    radius: inside(comparedLimits.poke.radius),
  }),
});

describe('the path', () => {
  it.each([null, ...rooms])('of a room leads to it: %s', (room) => {
    expect(readPath(pathOf({ page: 'springs', room }))).toEqual({ page: 'springs', room });
  });

  it.each(['', '#', '#/', '#/springs', '#/springs/'])('of the lab may be short: %j', (path) => {
    expect(readPath(path)).toEqual(lab);
  });
});

describe('the link', () => {
  it('carries every state there and back', () => {
    fc.assert(
      fc.property(states, (state) => {
        const { state: back, problems } = decodeLink(encodeLink(lab, state), defaultState);
        expect(problems).toEqual([]);
        expect(back).toEqual(state);
      }),
    );
  });

  it('survives being percent-encoded by what carries it', () => {
    fc.assert(
      fc.property(states, (state) => {
        expect(decodeLink(encodeURI(decodeURI(encodeLink(lab, state))), defaultState).state).toEqual(state);
      }),
    );
  });

  it('names scene and language even where they are the default: the next reader’s default may differ', () => {
    expect(encodeLink(lab, defaultState)).toBe('#/springs?version=1&scene=%22net%22&language=%22en%22');
  });

  it('keeps the good parts of a link with a bad one, and names the bad one', () => {
    const { state, problems } = decodeLink(
      '#/springs?scene="flag"&parameters={%22k%22:-5}&language="zh"',
      defaultState,
    );
    expect(state).toEqual({ ...defaultState, scene: 'flag', language: 'zh' });
    expect(problems).toEqual([{ part: 'parameters', value: '{"k":-5}' }]);
  });

  it.each([
    ['a part that does not exist', '#/springs?colour="red"', 'colour'],
    ['broken JSON', '#/springs?pins=[1', 'pins'],
    ['broken percent escapes', '#/springs?scene=%E0%A4%A', 'scene'],
    ['a parameter that does not exist', '#/springs?parameters={"q":1}', 'parameters'],
    ['a method that does not exist', '#/springs?parameters={"method":"magic"}', 'parameters'],
    ['two stopping rules at once', '#/springs?parameters={"stop_gradient":1,"stop_decrease":0.01}', 'parameters'],
    ['a scene name that could leave the folder', '#/springs?scene="../x"', 'scene'],
    [
      'a camera that looks nowhere',
      '#/springs?view={"exaggeration":1,"springs":true,"surface":true,"projector":false,"plot":"trace","camera":{"position":[1,1,1],"target":[1,1,1]}}',
      'view',
    ],
    ['a page that does not exist', '#/nowhere', '#'],
    ['a room that does not exist', '#/springs/cellar', '#'],
    ['a version of the future', '#/springs?version=2', 'version'],
    ['a part inherited by every object', '#/springs?toString=1', 'toString'],
  ])('refuses %s', (_, fragment, part) => {
    const { state, problems } = decodeLink(fragment, defaultState);
    expect(state).toEqual(defaultState);
    expect(problems.map((problem) => 'part' in problem && problem.part)).toEqual([part]);
  });

  it('reads a link made before there was a choice of plots', () => {
    const { plot: _, ...older } = { ...defaultState.view, springs: false };
    const path = encodeLink(lab, defaultState).split('?')[0];
    const view = encodeURIComponent(JSON.stringify(older));
    const { state, problems } = decodeLink(`${path}?view=${view}`, defaultState);
    expect(problems).toEqual([]);
    expect(state.view).toEqual({ ...older, plot: 'trace' });
  });

  it('does not read a link longer than any of ours', () => {
    const { state, problems } = decodeLink(`#/springs?pins=${'x'.repeat(longestLink)}`, defaultState);
    expect(state).toEqual(defaultState);
    expect(problems).toEqual([{ tooLong: longestLink + 15 }]);
  });

  it.each(['', '#', '#/springs', '#/springs?'])('takes “%s” for the default', (fragment) => {
    expect(decodeLink(fragment, defaultState)).toEqual({ route: lab, state: defaultState, problems: [] });
  });

  it('to the integrators carries every comparison there and back, and nothing of the springs', () => {
    fc.assert(
      fc.property(comparisons, (integrators) => {
        const { route, state, problems } = decodeLink(
          encodeLink({ page: 'integrators' }, { ...defaultState, scene: 'flag', integrators }),
          defaultState,
        );
        expect(problems).toEqual([]);
        expect(route).toEqual({ page: 'integrators' });
        expect(state).toEqual({ ...defaultState, integrators });
      }),
    );
  });

  it.each([
    ['no method', []],
    ['a method that does not exist', [{ method: 'magic', iterations: 1, substeps: 1 }]],
    ['half a substep', [{ method: 'newton', iterations: 1, substeps: 0.5 }]],
    ['more than fit side by side', Array(5).fill({ method: 'newton', iterations: 1, substeps: 1 })],
  ])('to the integrators is refused with %s', (_, chosen) => {
    const integrators = JSON.stringify({ ...defaultState.integrators, methods: chosen });
    const { state, problems } = decodeLink(`#/integrators?integrators=${integrators}`, defaultState);
    expect(state).toEqual(defaultState);
    expect(problems).toMatchObject([{ part: 'integrators' }]);
  });

  it('to the kinematics carries every arm and curve there and back, and nothing of the other labs', () => {
    fc.assert(
      fc.property(arms, (kinematics) => {
        const link = encodeLink({ page: 'kinematics' }, { ...defaultState, scene: 'flag', kinematics });
        const { route, state, problems } = decodeLink(link, defaultState);
        expect(problems).toEqual([]);
        expect(route).toEqual({ page: 'kinematics' });
        expect(state).toEqual({ ...defaultState, kinematics });
      }),
    );
  });

  it.each([
    ['no link', { links: [] }],
    ['a link without length', { links: [{ length: 0, bend: null }] }],
    ['a curve that does not exist', { curve: { kind: 'spiral' } }],
    ['a longer text than fits', { curve: { kind: 'letters', text: 'x'.repeat(25) } }],
    ['half a point', { points: 100.5 }],
  ])('to the kinematics is refused with %s', (_, wrong) => {
    const kinematics = encodeURIComponent(JSON.stringify({ ...defaultState.kinematics, ...wrong }));
    const { state, problems } = decodeLink(`#/kinematics?kinematics=${kinematics}`, defaultState);
    expect(state).toEqual(defaultState);
    expect(problems).toMatchObject([{ part: 'kinematics' }]);
  });

  it('leads to a section of the lesson, with the language and theme to read it in and nothing of the lab', () => {
    const state = { ...defaultState, scene: 'flag', parameters: { k: 5 }, language: 'zh', theme: 'dark' } as const;
    const link = encodeLink({ page: 'lesson', section: 'trick' }, state);
    expect(link).toBe('#/lesson/trick?language=%22zh%22&theme=%22dark%22');
    expect(decodeLink(link, defaultState)).toEqual({
      route: { page: 'lesson', section: 'trick' },
      state: { ...defaultState, language: 'zh', theme: 'dark' },
      problems: [],
    });
  });

  it.each(['#/lesson', '#/lesson/', '#/lesson?language="zh"'])('takes “%s” for the whole lesson', (fragment) => {
    expect(decodeLink(fragment, defaultState)).toMatchObject({
      route: { page: 'lesson', section: null },
      problems: [],
    });
  });

  it('refuses a part of the lab’s state in a link to the lesson', () => {
    const { problems } = decodeLink('#/lesson/trick?scene="flag"', defaultState);
    expect(problems).toEqual([{ part: 'scene', value: '"flag"' }]);
  });
});
