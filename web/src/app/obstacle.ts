import type { MessageKey } from './messages/index.ts';

/** Something without which the page cannot run at all, as a sentence. */
export class Obstacle extends Error {
  override name = 'Obstacle';
  readonly key: MessageKey;
  readonly params: Record<string, string>;

  constructor(key: MessageKey, params: Record<string, string> = {}) {
    super(`${key} ${JSON.stringify(params)}`);
    this.key = key;
    this.params = params;
  }
}
