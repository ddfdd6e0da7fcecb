import { beforeEach, describe, expect, it, vi } from 'vitest';
import { Actions } from '../../../web/src/app/actions.ts';
import { notices } from '../../../web/src/app/notices.ts';
import { route } from '../../../web/src/app/route.ts';
import type { Session } from '../../../web/src/app/session.ts';
import { defaultState, frame, state } from '../../../web/src/app/state.ts';
import { reading } from '../../../web/src/app/work.ts';
import type { Frame } from '../../../web/src/solver/frame.ts';

const actions = new Actions({} as Session); // which none of these asks

beforeEach(() => {
  state.value = { ...defaultState, parameters: { k: 5 } };
});

describe('setStoppingRule', () => {
  it('puts one rule in the place of the other', () => {
    actions.setStoppingRule('stop_gradient', 0.5);
    actions.setStoppingRule('stop_decrease', 1e-3);
    expect(state.value.parameters).toEqual({ k: 5, stop_decrease: 1e-3 });
  });

  it('takes both away', () => {
    actions.setStoppingRule('stop_gradient', 0.5);
    actions.setStoppingRule(null);
    expect(state.value.parameters).toEqual({ k: 5 });
  });

  it('keeps ε within what a link may carry', () => {
    actions.setStoppingRule('stop_gradient', 1e9);
    expect(state.value.parameters.stop_gradient).toBe(1e3);
  });
});

describe('while the files of a scene are being read', () => {
  /** Reads for ever. */
  class Reader extends EventTarget {
    static running = 0;

    constructor() {
      super();
      Reader.running++;
    }

    postMessage(): void {}

    terminate(): void {
      Reader.running--;
    }
  }

  beforeEach(() => {
    vi.stubGlobal('Worker', Reader);
    notices.value = [];
  });

  it('cancel() ends the reading, and nothing has changed', async () => {
    const before = state.value;
    const opening = actions.openScene('net');
    expect(reading.value).not.toBeNull();
    actions.cancel();
    await opening;
    expect([reading.value, Reader.running, state.value]).toEqual([null, 0, before]);
    expect(notices.value).toMatchObject([{ key: 'page.notice.cancelled' }]);
  });

  it('a reader who goes on to the lesson stays there', async () => {
    vi.stubGlobal('document', { documentElement: {} }); // whose language is set
    frame.value = {} as Frame; // the lab shows something
    const toTheLab = actions.follow({
      route: { page: 'springs', room: null },
      state: { ...state.value, scene: 'flag' },
      problems: [],
    });
    expect(reading.value).not.toBeNull();
    const lesson = { page: 'lesson', section: 'solving' } as const;
    await actions.follow({ route: lesson, state: state.value, problems: [] });
    actions.cancel();
    await toTheLab;
    expect(route.value).toEqual(lesson);
  });

  it('another scene takes the place of the one that was asked for', async () => {
    const first = actions.openScene('net');
    const second = actions.openScene('flag');
    await first;
    expect(reading.value).not.toBeNull();
    expect(Reader.running).toBe(1);
    actions.cancel();
    await second;
  });
});
