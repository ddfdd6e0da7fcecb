import { useState } from 'preact/hooks';
import type { Actions } from '../../app/actions.ts';
import { t } from '../../app/messages/index.ts';
import { cardId } from '../../app/pointing.ts';
import { liveFrame, pins, scene, state } from '../../app/state.ts';
import type { Thing } from '../../notation/symbols.ts';
import type { Frame } from '../../solver/frame.ts';
import './inspector.css';

/** Chooses a spring by its number: what a click on it does, for the keyboard. */
export function SpringInspector({ actions }: { actions: Actions }) {
  const count = scene.value.E.length / 2;
  return (
    <IndexField
      thing="spring"
      label={t('page.inspect.spring')}
      value={state.value.selection.spring}
      count={count}
      onChange={(spring) => actions.selectSpring(spring)}
    />
  );
}

/** Chooses a vertex by its number, and pins or frees it. */
export function VertexInspector({ actions }: { actions: Actions }) {
  const { vertex } = state.value.selection;
  const pinned = vertex !== null && pins.value.pinned.includes(vertex);
  return (
    <>
      <IndexField
        thing="vertex"
        label={t('page.inspect.vertex')}
        value={vertex}
        count={scene.value.m.length}
        onChange={(next) => actions.selectVertex(next)}
      />
      <button
        type="button"
        disabled={vertex === null}
        onClick={() => {
          const { p } = liveFrame.peek() as Frame;
          if (vertex !== null) actions.togglePin(vertex, [p[3 * vertex], p[3 * vertex + 1], p[3 * vertex + 2]]);
        }}
      >
        {t(pinned ? 'page.inspect.unpin' : 'page.inspect.pin')}
      </button>
    </>
  );
}

interface IndexFieldProps {
  thing: Thing;
  label: string;
  value: number | null;
  count: number;
  onChange: (index: number) => void;
}

function IndexField({ thing, label, value, count, onChange }: IndexFieldProps) {
  const [problem, setProblem] = useState<string | null>(null);
  const read = (text: string) => {
    const index = Number(text);
    const inside = text.trim() !== '' && Number.isInteger(index) && index >= 0 && index < count;
    setProblem(inside ? null : t('page.inspect.outside', { value: text, last: count - 1 }));
    if (inside) onChange(index);
  };
  return (
    <label class="index-field">
      {label}{' '}
      <input
        type="number"
        min={0}
        max={count - 1}
        value={value ?? ''}
        aria-invalid={problem !== null}
        aria-describedby={cardId}
        {...{ [`data-${thing}`]: value }}
        onChange={(event) => read(event.currentTarget.value)}
      />{' '}
      <span class="of">{t('page.inspect.range', { last: count - 1 })}</span>
      {problem && (
        <span class="index-problem" role="alert">
          {problem}
        </span>
      )}
    </label>
  );
}
