import { t } from '../../app/messages/index.ts';
import { appliedTheme } from '../../app/preferences.ts';
import type { Phase } from '../../solver/frame.ts';
import { darkPalette, lightPalette } from '../../views/scene3d/palette.ts';
import { legend } from './stage_signals.ts';

/** What the colours and lengths of the local view mean: stretch in per cent, and how much the gap is enlarged. */
export function LocalLegend() {
  const { strain } = palette();
  const { localExaggeration, strainRange } = legend.value;
  const percent = `${Number((100 * strainRange).toPrecision(2))} %`;
  return (
    <div class="legend">
      <p>
        <span>−{percent}</span>
        <span class="legend-scale" style={{ background: `linear-gradient(to right, ${strain.join(', ')})` }} />
        <span>+{percent}</span>
        <span>{t('page.legend.strain')}</span>
      </p>
      <Factor message="page.legend.drawn" factor={localExaggeration} />
    </div>
  );
}

/** What the pale net and the arrows of the global view mean. */
export function GlobalLegend({ phase }: { phase: Phase }) {
  const { globalExaggeration } = legend.value;
  return (
    <div class="legend">
      <p>
        <b style={{ color: palette().pin }}>◆</b>
        <span>{t('page.legend.pins')}</span>
        {phase === 'predict' && <span>{t('page.legend.inertial')}</span>}
        {phase === 'global' && <span>{t('page.legend.ghost')}</span>}
      </p>
      <Factor message="page.legend.moved" factor={globalExaggeration} />
    </div>
  );
}

/** Nothing where nothing is multiplied. */
function Factor({ message, factor }: { message: 'page.legend.drawn' | 'page.legend.moved'; factor: number | null }) {
  if (factor === null) return null;
  return <p>{factor === 1 ? t('page.legend.drawnTrue') : t(message, { factor })}</p>;
}

function palette() {
  return appliedTheme.value === 'dark' ? darkPalette : lightPalette;
}
