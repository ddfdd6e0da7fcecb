import { toFirst } from './follow_targets.ts';
import { largestTurn } from './ik_turns.ts';
import type { IkAnswer, IkOutcome, IkTask } from './inverse_kinematics.ts';
import type { SolverModule } from './module.ts';
import type { Outcome } from './protocol.ts';

/** From where the search for each target begins: where the one before ended, the hanging chain, or a pose made up anew. */
export type SweepStart = 'warm' | 'hanging' | 'random';

/** How a chain came along a curve. */
export interface Sweep {
  /** #T×#joints×3, m. */
  x: Float64Array;
  /** #T, m: between end effector and target. */
  errors: Float64Array;
  /** #T, rad: the largest turn of a joint from the target before; 0 at the first. */
  turns: Float64Array;
  outcomes: IkOutcome[];
}

/** Without the events, which for a long curve would fill the memory. */
type Answered = Pick<IkAnswer, 'x' | 'q' | 'error' | 'outcome'>;

/** The same sequence of poses every time: an experiment that can be repeated. */
const seed = 20;

/** Along `targets`, #T×3, m. The arm first goes to the first target as it likes; the task's turn limit holds from there on. */
export function sweep(
  solver: Pick<SolverModule, 'inverse_kinematics'>,
  task: IkTask,
  targets: Float64Array,
  start: SweepStart,
): Outcome<Sweep> {
  const random = randomNumbers(seed);
  const answers: Answered[] = [];
  for (let at = 0; at < targets.length / 3; at++) {
    const before = answers.at(-1);
    const { status, answer } = solver.inverse_kinematics({
      ...(before ? task : toFirst(task)),
      ...startOf(start, task, before, random),
      target: targets.subarray(3 * at, 3 * at + 3),
    });
    if (status.code !== 'ok') return { ok: false, status };
    const { x, q, error, outcome } = answer;
    answers.push({ x, q, error, outcome });
  }
  return {
    ok: true,
    value: {
      x: Float64Array.from(answers.flatMap(({ x }) => [...x])),
      errors: Float64Array.from(answers, ({ error }) => error),
      turns: Float64Array.from(answers, ({ q }, at) => (at === 0 ? 0 : largestTurn(answers[at - 1].q, q))),
      outcomes: answers.map(({ outcome }) => outcome),
    },
  };
}

function startOf(
  start: SweepStart,
  task: IkTask,
  before: Answered | undefined,
  random: () => number,
): Pick<IkTask, 'start' | 'start_q'> {
  const none = new Float64Array();
  if (start === 'random') return { start: randomPose(task, random), start_q: none };
  return { start: none, start_q: start === 'warm' && before ? before.q : none };
}

/** Every link in a direction of its own, all directions equally likely. */
function randomPose({ root, offsets }: IkTask, random: () => number): Float64Array {
  const x = [...root];
  for (let link = 0; link < offsets.length / 3; link++) {
    const height = 2 * random() - 1;
    const around = 2 * Math.PI * random();
    const across = Math.sqrt(1 - height * height);
    const direction = [across * Math.cos(around), height, across * Math.sin(around)];
    for (const component of direction) x.push(x[x.length - 3] + component);
  }
  return Float64Array.from(x);
}

/** From 0 to 1, by Marsaglia's xorshift. */
function randomNumbers(first: number): () => number {
  let state = first;
  return () => {
    state ^= state << 13;
    state ^= state >>> 17;
    state ^= state << 5;
    return (state >>> 0) / 2 ** 32;
  };
}
