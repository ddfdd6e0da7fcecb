import type { Frame, Phase, TraceEvent } from './frame.ts';
import { type Simulation, traceColumns } from './module.ts';

type TraceRow = Record<(typeof traceColumns)[number], number>;

/** The phase and iteration of a cursor position: 0 predict, 2k−1 local(k), 2k global(k), 2K+1 accept. */
export function placeOf(half_step: number, last_half_step: number): { phase: Phase; iteration: number } {
  if (half_step === 0) return { phase: 'predict', iteration: 0 };
  if (half_step === last_half_step) return { phase: 'accept', iteration: (last_half_step - 1) / 2 };
  return { phase: half_step % 2 === 1 ? 'local' : 'global', iteration: Math.ceil(half_step / 2) };
}

/** Copies what the page shows out of the module, so that the page owns it. */
export function readFrame(
  s: Simulation,
  wants: { pinned: Int32Array; selectedVertex: number | null; events: boolean },
): Frame {
  const half_step = s.half_step();
  const last_half_step = s.last_half_step();
  const place = placeOf(half_step, last_half_step);
  const vertex = wants.selectedVertex;
  return {
    step: s.step_number(),
    half_step,
    last_half_step,
    iterations: (last_half_step - 1) / 2,
    stopReason: s.stop_reason(),
    ...place,
    p: s.p().slice(),
    pBefore: s.p_before().slice(),
    d: place.phase === 'predict' ? null : s.d().slice(),
    pCurr: s.p_curr().slice(),
    pPrev: s.p_prev().slice(),
    prediction: s.inertial_prediction().slice(),
    pinned: wants.pinned,
    targets: s.targets().slice(),
    events: wants.events ? readTrace(s.trace(), last_half_step) : [],
    vertexEquation: vertex === null ? null : { vertex, ...s.probe_vertex(vertex) },
    stiffnessNumber: s.stiffness_number(),
    factorisations: { count: s.factorisation_count(), reason: s.factorisation_reason() },
    rememberedSteps: s.remembered_steps(),
    milliseconds: 0,
    profile: null,
  };
}

function readTrace(rows: Float64Array, last_half_step: number): TraceEvent[] {
  const width = traceColumns.length;
  return Array.from({ length: rows.length / width }, (_, row) => {
    const values = rows.subarray(row * width, (row + 1) * width);
    const columns = Object.fromEntries(traceColumns.map((name, column) => [name, values[column]])) as TraceRow;
    return { ...columns, ...placeOf(columns.half_step, last_half_step) };
  });
}
