import { expose } from 'comlink';
import createSolver from '#wasm/solver.js';
import { type EnergyRatios, energyOfOneSpring } from './energy_of_one_spring.ts';
import type { Parameters } from './module.ts';
import { type Case, type Errors, orderOfAccuracy } from './order_of_accuracy.ts';
import type { Outcome, Pins, Problem } from './protocol.ts';
import { type SceneTime, timeScene } from './time_scene.ts';
import { type RefactorisingTime, type SolvingTime, timeRefactorising, timeSolving } from './time_solving.ts';

/** What a worker of its own times and measures, so that neither the page nor a simulation waits. Whoever wants it to stop ends the worker. */
export interface TimingService {
  /** Compiles the module. Call once, before anything else. */
  start(wasmBinary: ArrayBuffer): Promise<void>;
  timeSolving(sides: readonly number[], report: (time: SolvingTime) => void): Promise<void>;
  timeRefactorising(side: number, iterations: number): Promise<Record<'dense' | 'sparse', RefactorisingTime>>;
  timeScene(problem: Problem, pins: Pick<Pins, 'pinned'>, parameters: Parameters): Promise<Outcome<SceneTime>>;
  orderOfAccuracy(name: Case): Promise<Errors[]>;
  energyOfOneSpring(products: readonly number[]): Promise<EnergyRatios[]>;
}

let solver: Awaited<ReturnType<typeof createSolver>>;

const service: TimingService = {
  async start(wasmBinary) {
    solver = await createSolver({ wasmBinary });
  },
  async timeSolving(sides, report) {
    timeSolving(solver, sides, report);
  },
  async timeRefactorising(side, iterations) {
    return timeRefactorising(solver, side, iterations);
  },
  async timeScene(problem, pins, parameters) {
    return timeScene(solver, problem, pins, parameters);
  },
  async orderOfAccuracy(name) {
    return orderOfAccuracy(solver, name);
  },
  async energyOfOneSpring(products) {
    return energyOfOneSpring(solver, products);
  },
};

expose(service);
