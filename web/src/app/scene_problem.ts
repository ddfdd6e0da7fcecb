import type { MessageKey } from './messages/index.ts';

/** A scene that cannot be had, as a sentence. */
export class SceneProblem extends Error {
  override name = 'SceneProblem';
  readonly key: MessageKey;
  readonly params: Record<string, string>;

  constructor(key: MessageKey, params: Record<string, string>) {
    super(key);
    this.key = key;
    this.params = params;
  }
}
