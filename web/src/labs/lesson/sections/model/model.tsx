import { inLanguage } from '../../../../app/messages/in_language.ts';
import { fillTemplate } from '../../../../lib/fill_template.ts';
import { formatLength, formatQuantity } from '../../../../lib/format.ts';
import { Formula } from '../../../../views/equations/formula.tsx';
import { Prose } from '../../../../views/equations/prose.tsx';
import { Question } from '../../../../views/equations/question.tsx';
import { MatrixTable } from '../../../../views/matrices/matrix_table.tsx';
import { Figure } from '../../figures/figure.tsx';
import type { FigureSession, FigureSettings } from '../../figures/figure_session.ts';
import { useFigure } from '../../figures/use_figure.ts';
import { InSlices } from '../../in_slices.tsx';
import { Sources } from '../../sources.tsx';
import { en } from './en.ts';
import { PullTable } from './pull_table.tsx';
import { zh } from './zh.ts';
import './model.css';

const hanging: FigureSettings = { scene: 'triangle', selection: { spring: 1, vertex: 2 } };
const pulling: FigureSettings = { scene: 'triangle', parameters: { k: 30 }, opening: [{ kind: 'play', steps: 6 }] };
const falling: FigureSettings = { scene: 'triangle', pins: [] };

export function Model() {
  const words = inLanguage({ en, zh });
  const figure = useFigure(hanging);
  return (
    <InSlices>
      <Prose text={words.intro} />
      <Figure figure={figure} pictures={['net']} sliders={['k', 'mass_scale']} caption={words.caption}>
        <Chosen figure={figure} words={words} />
        <div class="model-tables">
          <MatrixTable
            figure={figure}
            symbol="V"
            values={figure.scene.value.V}
            name={<Formula tex={String.raw`\symV`} />}
          />
          <MatrixTable
            figure={figure}
            symbol="E"
            values={figure.scene.value.E}
            name={<Formula tex={String.raw`\symE`} />}
          />
        </div>
      </Figure>
      <h3>{words.law.title}</h3>
      <Prose text={words.law.text} />
      <Question ask={words.pulls.ask} hint={words.pulls.hint} answer={words.pulls.answer}>
        <Pulls words={words.pulls} />
      </Question>
      <Question ask={words.least.ask} hint={words.least.hint} answer={words.least.answer}>
        <Falling caption={words.least.caption} />
      </Question>
      <Sources items={words.sources} />
    </InSlices>
  );
}

/** The chosen spring and vertex in words and present numbers. */
function Chosen({ figure, words }: { figure: FigureSession; words: { spring: string; vertex: string } }) {
  const { E, m } = figure.scene.value;
  const frame = figure.frame.value;
  const { spring, vertex } = figure.selection.value;
  if (!frame) return <p class="model-now" />;
  const sentences: string[] = [];
  if (spring !== null) {
    const [i, j] = [E[2 * spring], E[2 * spring + 1]];
    const now = Math.hypot(...[0, 1, 2].map((axis) => frame.p[3 * i + axis] - frame.p[3 * j + axis]));
    const rest = formatLength(figure.r.value[spring]);
    sentences.push(fillTemplate(words.spring, { spring, i, j, rest, now: formatLength(now) }));
  }
  if (vertex !== null) {
    const springs = Array.from({ length: E.length / 2 }, (_, e) => e).filter(
      (e) => E[2 * e] === vertex || E[2 * e + 1] === vertex,
    );
    const mass = formatQuantity(m[vertex] * figure.parameters.value.mass_scale, 'kg');
    sentences.push(fillTemplate(words.vertex, { vertex, mass, springs: springs.join(', ') }));
  }
  return <p class="model-now">{sentences.join(' ')}</p>;
}

function Pulls({ words }: { words: typeof en.pulls }) {
  const figure = useFigure(pulling);
  return (
    <Figure figure={figure} pictures={['net']} sliders={['k']} caption={words.caption}>
      <PullTable figure={figure} words={words} />
    </Figure>
  );
}

function Falling({ caption }: { caption: string }) {
  const figure = useFigure(falling);
  return <Figure figure={figure} pictures={['net']} caption={caption} />;
}
