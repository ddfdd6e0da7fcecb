import type { ComponentChildren } from 'preact';
import { useRef } from 'preact/hooks';
import { t } from '../../../app/messages/index.ts';
import { holds } from '../../../app/pointing.ts';
import { StepButton } from '../../../views/stepper/step_button.tsx';
import type { FigureSession } from './figure_session.ts';
import { SpringPicture } from './spring_picture.tsx';
import { useAwake } from './use_awake.ts';
import './figure.css';
import './side_by_side.css';

interface Props {
  figures: readonly FigureSession[];
  /** Of each. */
  names: readonly string[];
  /** What each has come to, in a few short lines. */
  readings: readonly string[];
  running: boolean;
  onToggle: () => void;
  onReset: () => void;
  /** What else is to be changed, and what is to be seen of all of them together. */
  children: ComponentChildren;
}

/** The same scene several times, under one clock. */
export function SideBySide({ figures, names, readings, running, onToggle, onReset, children }: Props) {
  const host = useRef<HTMLDivElement>(null);
  useAwake(host, figures);
  return (
    <div ref={host} class="figure side-by-side">
      <div class="figure-pictures">
        {figures.map((figure, at) => (
          <div key={names[at]} ref={holds(figure)} class="figure-picture">
            <p class="figure-picture-name">{names[at]}</p>
            <SpringPicture figure={figure} mode="net" name={names[at]} />
            <p class="side-by-side-reading">{readings[at]}</p>
          </div>
        ))}
      </div>
      <fieldset class="figure-transport" aria-label={t('page.transport.label')}>
        <StepButton icon="reset" label={t('page.transport.reset')} onClick={onReset} />
        <StepButton
          icon={running ? 'pause' : 'play'}
          label={t(running ? 'page.transport.pause' : 'page.transport.play')}
          onClick={onToggle}
        />
      </fieldset>
      {children}
    </div>
  );
}
