import { expose, transfer } from 'comlink';
import createSolver from '#wasm/solver.js';
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
  const { frame, checkpoint } = outcome.value;
  const arrays = [frame.p, frame.pBefore, frame.prediction, frame.targets, checkpoint.p_curr, checkpoint.p_prev];
  if (frame.d) arrays.push(frame.d);
  return transfer(
    outcome,
    arrays.map((array) => array.buffer),
  );
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
};

expose(service);
