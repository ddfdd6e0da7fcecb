import { expose, transfer } from 'comlink';
import createSolver from '#wasm/solver.js';
import type { EliminationStepRequest } from './matrices.ts';
import type { Ordering } from './module.ts';
import type {
  Checkpoint,
  MethodRequest,
  Outcome,
  Problem,
  ProgressMessage,
  Reply,
  Request,
  SolverService,
} from './protocol.ts';
import { SolverSession } from './solver_session.ts';

let session: SolverSession | null = null;

function theSession(): SolverSession {
  if (!session) throw new Error('the solver was asked before it was started');
  return session;
}

/** Hands the arrays of a reply over instead of copying them. */
function send<T extends Reply>(outcome: Outcome<T>): Outcome<T> {
  if (!outcome.ok) return outcome;
  const { frame } = outcome.value; // whose arrays are the checkpoint's too
  const arrays = [frame.p, frame.pBefore, frame.pCurr, frame.pPrev, frame.prediction, frame.targets];
  if (frame.d) arrays.push(frame.d);
  return transfer(
    outcome,
    arrays.map((array) => array.buffer),
  );
}

/** Hands over every array of an answer that nobody here keeps. */
function give<T extends object>(answer: T): T {
  return transfer(answer, buffersOf(answer));
}

function buffersOf(part: object): ArrayBuffer[] {
  if (ArrayBuffer.isView(part)) return [part.buffer as ArrayBuffer];
  return Object.values(part).flatMap((inner) => (typeof inner === 'object' && inner ? buffersOf(inner) : []));
}

const service: SolverService = {
  async start(wasmBinary: ArrayBuffer) {
    session = new SolverSession(await createSolver({ wasmBinary }), (progress) =>
      postMessage({ progress } satisfies ProgressMessage),
    );
  },
  async open(problem: Problem, request: Request, from: Checkpoint | null) {
    return send(theSession().open(problem, request, from));
  },
  async run(request: Request) {
    return send(theSession().run(request));
  },
  async compare(request: MethodRequest) {
    return theSession().compare(request);
  },
  async inspect(points: readonly Float64Array[]) {
    return theSession().inspect(points);
  },
  async matrices() {
    return give(theSession().matrices());
  },
  async linearlyImplicit() {
    return give(theSession().linearlyImplicit());
  },
  async elimination(ordering: Ordering) {
    return give(theSession().elimination(ordering));
  },
  async eliminationStep(request: EliminationStepRequest) {
    return give(theSession().eliminationStep(request));
  },
  async compareStorage() {
    return theSession().compareStorage();
  },
};

expose(service);
