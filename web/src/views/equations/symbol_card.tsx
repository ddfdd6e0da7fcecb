import { useLayoutEffect, useRef } from 'preact/hooks';
import { t } from '../../app/messages/index.ts';
import { symbolCommand } from '../../notation/macros.ts';
import { type SymbolId, symbol } from '../../notation/symbols.ts';
import { Formula } from './formula.tsx';
import { pointAt } from './pointing.ts';

interface Props {
  id: SymbolId;
  anchor: HTMLElement;
  /** The symbol's present value in words and numbers, if it has one here. */
  value: string | undefined;
}

/** Id of the one open card, for aria-describedby. */
export const symbolCardId = 'symbol-card';

/** What a symbol is: name, shape, unit, meaning and present value, beside the place that was pointed at. */
export function SymbolCard({ id, anchor, value }: Props) {
  const card = useRef<HTMLDivElement>(null);
  const { shape, unit, code, section, definition } = symbol(id);

  useLayoutEffect(() => {
    if (card.current) placeBeside(card.current, anchor);
  });

  useLayoutEffect(() => {
    const close = () => pointAt(null);
    const closeOnEscape = (event: KeyboardEvent) => {
      if (event.key === 'Escape') close();
    };
    const closeOutside = (event: PointerEvent) => {
      const inside =
        event.target instanceof Node && (card.current?.contains(event.target) || anchor.contains(event.target));
      if (!inside) close();
    };
    document.addEventListener('keydown', closeOnEscape);
    document.addEventListener('pointerdown', closeOutside);
    document.addEventListener('scroll', close, { capture: true, passive: true });
    return () => {
      document.removeEventListener('keydown', closeOnEscape);
      document.removeEventListener('pointerdown', closeOutside);
      document.removeEventListener('scroll', close, { capture: true });
    };
  }, [anchor]);

  return (
    <div ref={card} id={symbolCardId} role="tooltip" class="symbol-card">
      <p class="symbol-card-name">
        <Formula tex={symbolCommand(id)} /> <strong>{t(`symbols.name.${id}`)}</strong>
      </p>
      <p>{t(`symbols.meaning.${id}`)}</p>
      {definition && (
        <p class="symbol-card-definition">
          <Formula tex={definition} />
        </p>
      )}
      <dl>
        <dt>{t('equations.card.shape')}</dt>
        <dd>{shape.join(' × ') || t('equations.card.number')}</dd>
        <dt>{t('equations.card.unit')}</dt>
        <dd>{unit ?? t('equations.card.dimensionless')}</dd>
        <dt>{t('equations.card.code')}</dt>
        <dd>
          <code>{code}</code>
        </dd>
        {value !== undefined && (
          <>
            <dt>{t('equations.card.value')}</dt>
            <dd>{value}</dd>
          </>
        )}
      </dl>
      <p class="symbol-card-section">{t(`symbols.section.${section}`)}</p>
    </div>
  );
}

/** Above the anchor where there is room, else below; always inside the window. Touching it, so that a mouse can reach the card. */
function placeBeside(card: HTMLElement, anchor: HTMLElement): void {
  const margin = 8; // px
  const at = anchor.getBoundingClientRect();
  const { width, height } = card.getBoundingClientRect();
  const left = Math.min(at.left + at.width / 2 - width / 2, window.innerWidth - width - margin);
  const top = at.top - height >= margin ? at.top - height : Math.min(at.bottom, window.innerHeight - height - margin);
  card.style.left = `${Math.max(margin, left)}px`;
  card.style.top = `${Math.max(margin, top)}px`;
}
