import { t } from '../../app/messages/index.ts';
import { appliedTheme } from '../../app/preferences.ts';
import type { Phase } from '../../solver/frame.ts';
import { darkPalette, lightPalette } from '../../views/scene3d/palette.ts';
import { legend } from './stage_signals.ts';

/** What the colours and lengths of the local view mean: strain in per cent, and how much the gap is enlarged. */
export function LocalLegend({ phase }: { phase: Phase }) {
  const { strain } = appliedTheme.value === 'dark' ? darkPalette : lightPalette;
  const { localExaggeration, strainRange } = legend.value;
  const percent = `${Number((100 * strainRange).toPrecision(2))} %`;
  return (
    <>
      <p class="legend legend-strain">
        <span>−{percent}</span>
        <span
          class="legend-scale"
          style={{
            background: `linear-gradient(to right, ${strain.join(', ')})`,
          }}
        />
        <span>+{percent}</span>
        <span class="visually-hidden">
          {t('page.legend.strain')}: {t('page.legend.compressed')} – {t('page.legend.stretched')}
        </span>
        <span class="legend-words" aria-hidden="true">
          {t('page.legend.strain')}
        </span>
      </p>
      {phase !== 'predict' && (
        <p class="legend legend-factor">
          {localExaggeration === 1 ? t('page.legend.drawnTrue') : t('page.legend.drawn', { factor: localExaggeration })}
        </p>
      )}
    </>
  );
}

/** What the pale net and the arrows of the global view mean. */
export function GlobalLegend({ phase }: { phase: Phase }) {
  const { pin } = appliedTheme.value === 'dark' ? darkPalette : lightPalette;
  const { globalExaggeration } = legend.value;
  return (
    <>
      <p class="legend legend-strain">
        <span>
          <b style={{ color: pin }}>◆</b> {t('page.legend.pins')}
        </span>
        <span class="legend-words">{t('page.legend.ghost')}</span>
      </p>
      <p class="legend legend-factor">
        {phase === 'predict' && `${t('page.legend.inertial')} · `}
        {globalExaggeration === 1 ? t('page.legend.drawnTrue') : t('page.legend.moved', { factor: globalExaggeration })}
      </p>
    </>
  );
}
