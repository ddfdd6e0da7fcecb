import { beforeEach, expect, onTestFinished, test } from 'vitest';
import { defaultIntegrators, type IntegratorsSettings } from '../../../web/src/app/integrators.ts';
import { IntegratorsSession } from '../../../web/src/app/integrators_session.ts';
import { notices } from '../../../web/src/app/notices.ts';
import { openedScenes } from '../../../web/src/app/scene_library.ts';
import { SideBySide } from '../../../web/src/app/side_by_side.ts';
import { defaultState, state } from '../../../web/src/app/state.ts';
import { noScene, type Scene } from '../../../web/src/scene/scene.ts';
import { SideBySideSession } from '../../../web/src/solver/side_by_side.ts';
import { solver } from '../../support/open_simulation.ts';
import { PortWorker } from '../../support/port_worker.ts';
import { net } from '../../support/small_scenes.ts';

const scene: Scene = { ...noScene, ...net(3), name: 'three', k: 1e3, iterations: 10 };
const smaller: Scene = { ...noScene, ...net(2), name: 'two', k: 1e3, iterations: 10 };
const local = (iterations: number) => ({ method: 'local-global', iterations, substeps: 1 }) as const;

function compare(change: Partial<IntegratorsSettings>): void {
  state.value = { ...state.value, integrators: { ...state.value.integrators, ...change } };
}

function newSession(): IntegratorsSession {
  const session = new SideBySideSession(solver);
  const worker = new PortWorker({
    start: async () => {},
    open: async (...request: Parameters<SideBySideSession['open']>) => session.open(...request),
    change: async (...request: Parameters<SideBySideSession['change']>) => session.change(...request),
    run: async (...request: Parameters<SideBySideSession['run']>) => session.run(...request),
  });
  onTestFinished(() => worker.terminate());
  return new IntegratorsSession(
    new SideBySide(
      () => worker.asWorker(),
      async () => new ArrayBuffer(0),
    ),
  );
}

beforeEach(() => {
  notices.value = [];
  openedScenes.value = [scene, smaller];
  const integrators = { ...defaultIntegrators, scene: 'three', methods: [local(1), local(10)] };
  state.value = { ...defaultState, integrators };
});

test('what the state wants is opened, and changed while its motion goes on', async () => {
  const session = newSession();
  await session.pursue();
  const { run } = session;
  expect(run.scene.value).toBe(scene);
  await run.run(3);
  compare({ methods: [local(1), local(10), local(50)] });
  await session.pursue();
  expect(run.states.value).toHaveLength(3);
  expect(run.step.value).toBe(3);
  compare({ scene: 'two' });
  await session.pursue();
  expect(run.scene.value).toBe(smaller);
  expect(run.step.value).toBe(0);
});

test('the last of several wishes wins', async () => {
  const session = newSession();
  const pursued = session.pursue();
  compare({ methods: [local(50)] });
  compare({ methods: [local(2), local(3), local(4)] });
  await pursued;
  expect(session.run.states.value).toHaveLength(3);
});

test('what is refused is said and taken back', async () => {
  const session = newSession();
  await session.pursue();
  const before = state.value.integrators;
  compare({ parameters: { k: 1e7, delta_t: 1, mass_scale: 1e-2 } }); // κ of the order of 1e9 and more
  await session.pursue();
  expect(notices.value).toMatchObject([{ key: 'page.errors.too_stiff' }]);
  expect(state.value.integrators).toBe(before);
});

test('a scene that does not exist leaves the one before', async () => {
  const session = newSession();
  await session.pursue();
  compare({ scene: 'nowhere' });
  await session.pursue();
  expect(notices.value).toMatchObject([{ key: 'page.errors.sceneUnknown' }]);
  expect(state.value.integrators.scene).toBe('three');
  expect(session.run.scene.value).toBe(scene);
});

test('another file of the same name takes the place of the first', async () => {
  const session = newSession();
  await session.pursue();
  const again = { ...smaller, name: 'three' };
  openedScenes.value = [again];
  compare({});
  await session.pursue();
  expect(session.run.scene.value).toBe(again);
});
