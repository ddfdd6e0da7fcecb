import { describeStatus } from '../../web/src/solver/describe_status.ts';
import type { Status } from '../../web/src/solver/module.ts';

/** What the module refuses ends the benchmark. */
export function succeed(status: Status): void {
  if (status.code !== 'ok') throw new Error(describeStatus(status));
}
