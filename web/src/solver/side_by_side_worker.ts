import { expose, transfer } from 'comlink';
import createSolver from '#wasm/solver.js';
import { type SideBySideService, SideBySideSession, type VariantState } from './side_by_side.ts';

let session: SideBySideSession | null = null;

function theSession(): SideBySideSession {
  if (!session) throw new Error('the simulations were asked before they were started');
  return session;
}

/** Hands the positions over instead of copying them. */
function send<T>(reply: T, states: readonly VariantState[]): T {
  return transfer(
    reply,
    states.map(({ p }) => p.buffer),
  );
}

const service: SideBySideService = {
  async start(wasmBinary) {
    session = new SideBySideSession(await createSolver({ wasmBinary }));
  },
  async open(problem, variants, pins, from) {
    const outcome = theSession().open(problem, variants, pins, from);
    return outcome.ok ? send(outcome, outcome.value.states) : outcome;
  },
  async change(variants) {
    const outcome = theSession().change(variants);
    return outcome.ok ? send(outcome, outcome.value.states) : outcome;
  },
  async run(pins, pull, steps) {
    const states = theSession().run(pins, pull, steps);
    return send(states, states);
  },
  async sameInstant(leader, pins, pull) {
    const outcome = theSession().sameInstant(leader, pins, pull);
    return outcome.ok ? send(outcome, outcome.value.states) : outcome;
  },
};

expose(service);
