import { computed, effect, untracked } from '@preact/signals';
import { sameJson } from '../lib/same_json.ts';
import type { Scene } from '../scene/scene.ts';
import { defaultIntegrators, type IntegratorsSettings, variantsOn } from './integrators.ts';
import { findScene, openedScenes } from './scene_library.ts';
import { seekScene } from './seek_scene.ts';
import { SideBySide } from './side_by_side.ts';
import { pinsOn, state } from './state.ts';

/** Makes the integrators lab's simulations what the state says, one change after the other; what is refused is taken back in the state. */
export class IntegratorsSession {
  readonly run: SideBySide;
  /** What runs; null before anything does. */
  private accepted: IntegratorsSettings | null = null;
  private working = false;

  constructor(run: SideBySide = new SideBySide()) {
    this.run = run;
  }

  /** Begins to follow the state and the display's refresh. Returns how to stop. */
  follow(): () => void {
    const wanted = computed(() => state.value.integrators);
    const stopFollowing = effect(() => {
      void wanted.value;
      untracked(() => void this.pursue());
    });
    const stopRun = this.run.follow();
    return () => {
      stopFollowing();
      stopRun();
    };
  }

  /** Until what runs is what is wanted: the last wish wins. */
  async pursue(): Promise<void> {
    if (this.working) return;
    this.working = true;
    try {
      while (state.value.integrators !== this.accepted) {
        const wanted = state.value.integrators;
        if (await this.make(wanted)) this.accepted = wanted;
        else if (!this.fallBack(wanted)) return;
      }
    } finally {
      this.working = false;
    }
  }

  private async make(wanted: IntegratorsSettings): Promise<boolean> {
    const { value: shown } = this.run.scene;
    if (this.accepted?.scene === wanted.scene && isCurrent(shown)) return this.change(shown, this.accepted, wanted);
    const scene = await seekScene((signal) => findScene(wanted.scene, signal));
    if (!scene) return false;
    this.run.playing.value = false;
    return this.run.open(variantsOn(scene, wanted), { scene, pins: pinsOn(scene, null), from: null });
  }

  private async change(scene: Scene, before: IntegratorsSettings, wanted: IntegratorsSettings): Promise<boolean> {
    const variants = variantsOn(scene, wanted);
    if (sameJson(variants, variantsOn(scene, before))) return true; // the pointer's settings
    return this.run.change(variants);
  }

  /** Puts back what ran before, or at the beginning the default; what was chosen since is made next. False when there is nothing left to try. */
  private fallBack(failed: IntegratorsSettings): boolean {
    if (state.value.integrators !== failed) return true;
    const last = this.accepted ?? defaultIntegrators;
    if (failed === last) return false;
    state.value = { ...state.value, integrators: last };
    return true;
  }
}

/** A file of the same name may have been opened since. */
function isCurrent(scene: Scene): boolean {
  const opened = openedScenes.value.find(({ name }) => name === scene.name);
  return !opened || opened === scene;
}
