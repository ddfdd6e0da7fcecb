import { beforeEach, describe, expect, it } from 'vitest';
import { Actions } from '../../../web/src/app/actions.ts';
import type { Session } from '../../../web/src/app/session.ts';
import { defaultState, state } from '../../../web/src/app/state.ts';

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
