import type { ComponentChildren } from 'preact';

/** Names and values, one below the other; what is null or false is left out. */
export function Facts({ facts }: { facts: readonly (Fact | null | false)[] }) {
  return (
    <dl>
      {facts.map(
        (fact, at) =>
          fact && (
            <div key={at}>
              <dt>{fact[0]}</dt>
              <dd>{fact[1]}</dd>
            </div>
          ),
      )}
    </dl>
  );
}

export type Fact = readonly [name: ComponentChildren, value: ComponentChildren];
