import type { Ref } from 'preact';
import { inLanguage } from '../../app/messages/in_language.ts';
import { t } from '../../app/messages/index.ts';
import { Icon } from '../../lib/icon.tsx';
import { en } from './arm_en.ts';
import { zh } from './arm_zh.ts';
import { type FloorPen, strokesNow } from './floor_pen.ts';

interface Props {
  pen: FloorPen;
  /** Is given the button that takes the pen. */
  toggle: Ref<HTMLButtonElement>;
  onFit: () => void;
}

/** Takes the pen for the floor or puts it away, and clears what it has drawn. */
function FloorPenButtons({ pen, toggle }: Pick<Props, 'pen' | 'toggle'>) {
  const words = inLanguage({ en, zh });
  const on = pen.on.value;
  const blank = strokesNow().length === 0;
  return (
    <>
      <button
        ref={toggle}
        type="button"
        class="floor-pen"
        aria-pressed={on}
        onClick={({ detail }) => (on ? pen.putAway() : pen.take(detail === 0))}
      >
        {words.draw}
      </button>
      {on && (
        <button type="button" aria-disabled={blank} onClick={blank ? undefined : () => pen.clear()}>
          {words.clear}
        </button>
      )}
    </>
  );
}

export function ArmTools({ pen, toggle, onFit }: Props) {
  const words = inLanguage({ en, zh });
  return (
    <div class="arm-tools">
      <FloorPenButtons pen={pen} toggle={toggle} />
      <button
        type="button"
        class="arm-fit"
        aria-label={t('page.stage.fit')}
        title={t('page.stage.fit')}
        onClick={onFit}
      >
        <Icon name="fit" />
      </button>
      <p class="arm-hint">{pen.on.value ? words.penHint : words.hint}</p>
    </div>
  );
}
