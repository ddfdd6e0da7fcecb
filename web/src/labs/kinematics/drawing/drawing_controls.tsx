import type { ComponentChildren } from 'preact';
import { useRef } from 'preact/hooks';
import type { Actions } from '../../../app/actions.ts';
import { inLanguage } from '../../../app/messages/in_language.ts';
import { state } from '../../../app/state.ts';
import { type CurveChoice, type Shape, shapes } from '../../../curves/curve_choice.ts';
import type { FloorPen } from '../../../views/scene3d/floor_pen.ts';
import { CurvePicture } from './curve_picture.tsx';
import { en } from './en.ts';
import { first, wave } from './examples.ts';
import { FormulaEditor } from './formula_editor.tsx';
import { LettersEditor } from './letters_editor.tsx';
import { PathEditor } from './path_editor.tsx';
import { zh } from './zh.ts';
import './drawing.css';

type Kind = CurveChoice['kind'];

interface Props {
  actions: Actions;
  pen: FloorPen;
}

/** What the arm draws: a shape, letters, a formula, what is drawn by hand, or an SVG path. */
export function DrawingControls({ actions, pen }: Props) {
  const words = inLanguage({ en, zh });
  const { mode, curve } = state.value.kinematics;
  const latest = useRef<Partial<Record<Kind, CurveChoice>>>({ ...shapeChoices, ...first });
  latest.current[curve.kind] = curve;
  const drawn = mode === 'draw' ? curve : null;
  const shown = pen.on.value ? 'hand' : drawn?.kind;

  const choose = (kind: Kind, byKeys: boolean) => {
    pen.putAway();
    const choice = latest.current[kind];
    if (choice) actions.setKinematics({ mode: 'draw', curve: choice });
    if (kind === 'hand') pen.take(byKeys);
  };
  const button = (kind: Kind, name: ComponentChildren) => (
    <button
      key={kind}
      type="button"
      aria-pressed={kind === shown}
      title={words.kinds[kind]}
      onClick={({ detail }) => choose(kind, detail === 0)}
    >
      <CurvePicture choice={pictures[kind]} />
      {name}
    </button>
  );
  return (
    <section class="drawing-controls" aria-labelledby="drawing-heading" data-curve={shown}>
      <h3 id="drawing-heading">{words.heading}</h3>
      <fieldset class="curve-kinds">
        <legend class="visually-hidden">{words.heading}</legend>
        {shapes.map((kind) => button(kind, <span class="visually-hidden">{words.kinds[kind]}</span>))}
        {(['letters', 'formula', 'hand', 'path'] as const).map((kind) => button(kind, words.kinds[kind]))}
      </fieldset>
      {drawn?.kind === 'letters' && <LettersEditor drawn={drawn} actions={actions} />}
      {drawn?.kind === 'formula' && <FormulaEditor drawn={drawn} actions={actions} />}
      {drawn?.kind === 'path' && <PathEditor drawn={drawn} actions={actions} />}
      {shown === 'hand' && <p class="curve-hint">{words.hand.hint}</p>}
    </section>
  );
}

const shapeChoices: Record<Shape, CurveChoice> = {
  circle: { kind: 'circle' },
  square: { kind: 'square' },
  heart: { kind: 'heart' },
  triangle: { kind: 'triangle' },
  star: { kind: 'star' },
};

const pictures: Record<Kind, CurveChoice> = {
  ...shapeChoices,
  letters: { kind: 'letters', text: 'Aa' },
  formula: first.formula,
  hand: wave,
  path: first.path,
};
