import { describeStatus } from '../src/solver/describe_status.ts';
import { loadSolver } from './load_solver.ts';
import { ikHelp, parseIkArguments } from './parse_ik_arguments.ts';
import { UsageError } from './usage_error.ts';

try {
  const task = parseIkArguments(process.argv.slice(2));
  process.stdout.write(task ? `${JSON.stringify(await answerTo(task))}\n` : ikHelp);
} catch (error) {
  if (!(error instanceof UsageError)) throw error;
  process.stderr.write(`${error.message}\n`);
  process.exitCode = 2;
}

/** What the command prints. */
async function answerTo(task: NonNullable<ReturnType<typeof parseIkArguments>>) {
  const solver = await loadSolver();
  const { status, answer } = solver.inverse_kinematics(task);
  if (status.code !== 'ok') throw new UsageError(describeStatus(status));
  return {
    status: answer.outcome,
    iterations: answer.iterations,
    error: answer.error, // m
    joints: Array.from({ length: answer.x.length / 3 }, (_, i) => [...answer.x.subarray(3 * i, 3 * i + 3)]), // m
    errors: [...answer.errors], // m, one an iteration
  };
}
