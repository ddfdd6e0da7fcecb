import { useSignal, useSignalEffect } from '@preact/signals';
import type { ComponentChildren } from 'preact';
import { useLayoutEffect, useRef } from 'preact/hooks';
import type { Figure } from '../../app/figure.ts';
import { highlighted, litThings, nothing } from '../../app/highlight.ts';
import { inLanguage } from '../../app/messages/in_language.ts';
import { appliedTheme } from '../../app/preferences.ts';
import { type Selection, state } from '../../app/state.ts';
import { Icon } from '../../lib/icon.tsx';
import type { SymbolId } from '../../notation/symbols.ts';
import { en } from './en.ts';
import { inkOf } from './ink_of.ts';
import { moveInPattern } from './move_in_pattern.ts';
import type { Pattern, Place } from './pattern.ts';
import { SparsityControl, zoomStride } from './sparsity_control.ts';
import type { Marks } from './types.ts';
import './sparsity.css';
import { zh } from './zh.ts';

/** A matrix, and what its rows, columns and entries mean. To be the same object from render to render. */
export interface SparsityModel {
  symbol: SymbolId;
  pattern: Pattern;
  /** For each kind of entry: custom properties that hold its colours. */
  kinds: readonly (readonly string[])[];
  write: (value: number) => string;
  head: (axis: 'row' | 'column', index: number) => string;
  /** What of the figure a place stands for. */
  thingsAt: (place: Place) => Selection;
  /** Where a spring and a vertex stand in the matrix. */
  marksOf: (things: Selection) => Marks;
  /** A place in words, as read out: "row 12 (spring 12), column 3 (vertex 3): +1". */
  describe: (place: Place) => string;
}

interface Props {
  figure: Figure;
  model: SparsityModel;
  /** What the matrix is, for those who cannot see it. */
  label: string;
  onSelect: (things: Selection) => void;
  /** What stands beside the buttons. */
  children?: ComponentChildren;
}

/**
 * A sparse matrix of any size. The wheel scrolls the page, with ctrl it zooms, as two fingers do; dragging pans. It is one tab stop: arrows go from
 * entry to entry, with Shift from cell to cell, + − 0 zoom, Enter selects what the cell stands for.
 */
export function SparsityView({ figure, model, label, onSelect, children }: Props) {
  const words = inLanguage({ en, zh });
  const canvas = useRef<HTMLCanvasElement>(null);
  const control = useRef<SparsityControl | null>(null);
  const here = useSignal<Place>({ row: 0, column: 0 });
  const hasFocus = useSignal(false);
  const pointedAt = useSignal<Place | null>(null);
  const latest = useRef({ model, onSelect });
  latest.current = { model, onSelect };

  useLayoutEffect(() => {
    const element = canvas.current as HTMLCanvasElement;
    const made = new SparsityControl(element, {
      onHover: (place) => {
        pointedAt.value = place;
        highlighted.value = place
          ? { ...nothing, symbols: [latest.current.model.symbol], figure, ...latest.current.model.thingsAt(place) }
          : nothing;
      },
      onTap: (place) => {
        here.value = place;
        pointedAt.value = place;
        latest.current.onSelect(latest.current.model.thingsAt(place));
      },
    });
    control.current = made;
    const observer = new ResizeObserver(() => made.resize());
    observer.observe(element);
    return () => {
      observer.disconnect();
      made.dispose();
    };
  }, [figure]);

  const shown = useSignal(model);
  shown.value = model;
  useSignalEffect(() => {
    const { pattern, kinds, write, head, marksOf } = shown.value;
    void [appliedTheme.value, state.value.view.projector];
    const lit = litThings(figure);
    const marked = lit.spring === null && lit.vertex === null ? figure.selection.value : lit;
    control.current?.show({
      pattern,
      write,
      head,
      ink: inkOf(kinds),
      marks: marksOf(marked),
      focus: hasFocus.value ? inMatrix(here.value, pattern) : null,
    });
  });

  const place = inMatrix(here.value, model.pattern);
  const things = model.thingsAt(place);
  const point = (next: Place) => {
    pointedAt.value = next;
    highlighted.value = { ...nothing, symbols: [model.symbol], figure, ...model.thingsAt(next) };
  };
  const move = (next: Place) => {
    here.value = next;
    point(next);
    control.current?.reveal(next);
  };

  const onKeyDown = (event: KeyboardEvent) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const next = moveInPattern(event.key, model.pattern, place, event.shiftKey);
    if (next) move(next);
    else if (event.key === '+' || event.key === '=') control.current?.zoomTo(zoomStride, place);
    else if (event.key === '-') control.current?.zoomTo(1 / zoomStride, place);
    else if (event.key === '0') control.current?.fit();
    else if (event.key === 'Enter' || event.key === ' ') onSelect(things);
    else return;
    event.preventDefault();
    event.stopPropagation(); // here arrows move in the matrix, not the cursor in time
  };

  return (
    <div class="sparsity">
      <div class="sparsity-bar">
        {children}
        <span class="sparsity-zoom">
          <button
            type="button"
            aria-label={words.closer}
            title={words.closer}
            onClick={() => control.current?.zoom(zoomStride)}
          >
            +
          </button>
          <button
            type="button"
            aria-label={words.farther}
            title={words.farther}
            onClick={() => control.current?.zoom(1 / zoomStride)}
          >
            −
          </button>
          <button type="button" aria-label={words.fit} title={words.fit} onClick={() => control.current?.fit()}>
            <Icon name="fit" />
          </button>
        </span>
      </div>
      <div
        ref={reachable}
        class="sparsity-area"
        role="application"
        aria-label={label}
        aria-roledescription={words.role}
        aria-description={words.keys}
        data-points
        onKeyDown={onKeyDown}
        onFocus={() => {
          hasFocus.value = true;
          point(place);
        }}
        onBlur={() => {
          hasFocus.value = false;
          pointedAt.value = null;
          highlighted.value = nothing;
        }}
      >
        <canvas ref={canvas} />
      </div>
      <p class="sparsity-readout" aria-live={hasFocus.value ? 'polite' : 'off'} data-testid="sparsity-readout">
        {pointedAt.value ? model.describe(inMatrix(pointedAt.value, model.pattern)) : words.invite}
      </p>
    </div>
  );
}

/** By the keyboard: arrow keys mean something in an application. */
function reachable(application: HTMLElement | null): void {
  if (application) application.tabIndex = 0;
}

function inMatrix({ row, column }: Place, { rows, columns }: Pattern): Place {
  return { row: Math.min(row, Math.max(0, rows - 1)), column: Math.min(column, Math.max(0, columns - 1)) };
}
