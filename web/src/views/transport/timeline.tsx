import { useRef } from 'preact/hooks';
import type { Actions } from '../../app/actions.ts';
import { t } from '../../app/messages/index.ts';
import { furthestStep, playing } from '../../app/state.ts';
import { RangeInput } from '../../lib/range_input.tsx';
import { steps125 } from '../../lib/steps_125.ts';
import { useWidth } from '../../lib/use_width.ts';
import type { Frame } from '../../solver/frame.ts';
import { statusText } from './status_text.ts';
import './timeline.css';

interface Props {
  frame: Frame;
  actions: Actions;
  /** With numbers at the ticks. */
  large?: boolean;
}

/** CSS pixels: half the thumb of a slider, which is how far from its end it comes (style.css). */
const inset = 9;

/**
 * Time on two levels: a line of time steps, and one of the half-steps inside the present one, which unfolds from its tick. Each is a slider.
 */
export function Timeline({ frame: f, actions, large = false }: Props) {
  const host = useRef<HTMLDivElement>(null);
  const width = useWidth(host);
  const first = f.step - f.rememberedSteps;
  const last = playing.value ? f.step : Math.max(f.step, furthestStep.value); // playing, nobody hears of every step
  const stands = last > first ? (f.step - first) / (last - first) : 0; // where a slider without a choice has its thumb
  return (
    <div ref={host} class={large ? 'timeline timeline-large' : 'timeline'}>
      {large && <Ticks first={first} last={last} here={f.step} width={width} />}
      <RangeInput
        class="timeline-steps"
        min={first}
        max={last}
        value={f.step}
        disabled={first === last}
        aria-label={t('page.timeline.steps')}
        title={t('page.timeline.steps')}
        aria-valuetext={t('page.timeline.step', { step: f.step, first, last })}
        onValue={(value) => actions.goToStep(value)}
      />
      {width > 0 && <Unfolded frame={f} from={inset + stands * (width - 2 * inset)} width={width} large={large} />}
      <RangeInput
        class="timeline-half-steps"
        min={0}
        max={f.last_half_step}
        value={f.half_step}
        aria-label={t('page.transport.scrubber')}
        aria-valuetext={statusText(f)}
        onValue={(value) => actions.seek(value)}
      />
      <div class="timeline-ends" aria-hidden="true">
        <span>{t('page.phase.predict')}</span>
        <span>
          {f.iterations} × (<span class="local">{t('page.phase.local')}</span>,{' '}
          <span class="global">{t('page.phase.global')}</span>)
        </span>
        <span>{t('page.phase.accept')}</span>
      </div>
    </div>
  );
}

/** The time steps that can be gone to, as many ticks as find room; those ahead are pale. */
function Ticks({ first, last, here, width }: { first: number; last: number; here: number; width: number }) {
  const place = (step: number) => inset + ((width - 2 * inset) * (step - first)) / Math.max(1, last - first);
  const apart = (CSSPixels: number) =>
    steps125(1, 1000).find((stride) => place(first + stride) - place(first) >= CSSPixels) ?? 1000;
  const multiples = (stride: number) =>
    Array.from({ length: last - first + 1 }, (_, at) => first + at).filter((step) => step % stride === 0);
  const ahead = (step: number) => (step > here ? 'ahead' : '');
  return (
    <svg class="timeline-ticks" width={width} height={28} aria-hidden="true">
      {width > 0 && (
        <>
          {multiples(apart(5)).map((step) => (
            <line key={step} class={ahead(step)} x1={place(step)} x2={place(step)} y1={20} y2={28} />
          ))}
          {multiples(apart(40))
            .filter((step) => Math.abs(place(step) - place(here)) >= 40)
            .map((step) => (
              <text key={step} class={ahead(step)} x={place(step)} y={14} text-anchor="middle">
                {step}
              </text>
            ))}
          <text class="here" x={Math.min(Math.max(place(here), 30), width - 30)} y={14} text-anchor="middle">
            t = {here}
          </text>
        </>
      )}
    </svg>
  );
}

/** The one time step spread out: predict, then local and global by turns, then accept. */
function Unfolded({ frame: f, from, width, large }: { frame: Frame; from: number; width: number; large: boolean }) {
  const { half_step, last_half_step: last } = f;
  const spacing = (width - 2 * inset) / last;
  const place = (h: number) => inset + h * spacing;
  const [fold, cells] = large ? [44, 18] : [10, 0];
  const pattern = large ? 'timeline-rounds-large' : 'timeline-rounds';
  return (
    <svg class="timeline-unfolded" width={width} height={fold + cells} aria-hidden="true">
      <path d={`M${from - 3} 0H${from + 3}L${width} ${fold}H0Z`} />
      {large && (
        <text x={Math.min(Math.max((from + width / 2) / 2, 115), width - 115)} y={fold - 9} text-anchor="middle">
          {t('page.timeline.unfolded', { step: f.step })}
        </text>
      )}
      {cells > 0 && (
        <>
          <pattern id={pattern} x={place(0.5)} width={2 * spacing} height={cells} patternUnits="userSpaceOnUse">
            <rect class="local" width={spacing} height={cells} />
            <rect class="global" x={spacing} width={spacing} height={cells} />
          </pattern>
          <rect class="cell" x={0} y={fold} width={place(0.5)} height={cells} />
          <rect
            x={place(0.5)}
            y={fold}
            width={Math.max(0, last - 1) * spacing}
            height={cells}
            fill={`url(#${pattern})`}
          />
          <rect class="cell" x={place(last - 0.5)} y={fold} width={width - place(last - 0.5)} height={cells} />
          <rect
            class={`here ${f.phase}`}
            x={Math.max(0, place(half_step - 0.5))}
            y={fold}
            width={Math.max(3, Math.min(width, place(half_step + 0.5)) - Math.max(0, place(half_step - 0.5)))}
            height={cells}
          />
        </>
      )}
    </svg>
  );
}
