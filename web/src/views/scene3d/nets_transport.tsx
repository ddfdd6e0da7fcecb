import { t } from '../../app/messages/index.ts';
import type { SideBySide } from '../../app/side_by_side.ts';
import { Icon } from '../../lib/icon.tsx';

/** The clock of all variants. */
export function NetsTransport({ run, onFit }: { run: SideBySide; onFit: () => void }) {
  const playing = run.playing.value;
  const off = !run.alive.value;
  const toggle = () => {
    run.playing.value = !playing;
  };
  const step = () => {
    run.playing.value = false;
    void run.run(1);
  };
  const restart = () => {
    run.pull.value = null; // from where the nets were then
    void run.reset();
  };
  return (
    <fieldset class="nets-transport" aria-label={t('page.transport.label')}>
      <button type="button" class="play" aria-disabled={off} onClick={off ? undefined : toggle}>
        <Icon name={playing ? 'pause' : 'play'} />
        {t(playing ? 'page.transport.pause' : 'page.transport.play')}
      </button>
      <IconButton icon="nextStep" label={t('page.transport.nextStep')} off={off} onClick={step} />
      <IconButton icon="reset" label={t('page.nets.restart')} onClick={restart} />
      <IconButton icon="fit" label={t('page.stage.fit')} onClick={onFit} />
      <p class="nets-place" aria-live={playing ? 'off' : 'polite'}>
        {t('page.nets.place', { step: run.step.value })}
      </p>
    </fieldset>
  );
}

interface IconButtonProps {
  icon: 'nextStep' | 'reset' | 'fit';
  label: string;
  off?: boolean;
  onClick: () => void;
}

function IconButton({ icon, label, off = false, onClick }: IconButtonProps) {
  return (
    <button type="button" aria-label={label} title={label} aria-disabled={off} onClick={off ? undefined : onClick}>
      <Icon name={icon} />
    </button>
  );
}
