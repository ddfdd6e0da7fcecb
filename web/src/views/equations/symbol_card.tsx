import { useLayoutEffect, useRef } from 'preact/hooks';
import { highlighted, litThings } from '../../app/highlight.ts';
import { t } from '../../app/messages/index.ts';
import { cardId, type Hook, type Pointed, pointAway, pointed } from '../../app/pointing.ts';
import { sizeOf, symbolValue } from '../../app/symbol_value.ts';
import { symbolCommand } from '../../notation/macros.ts';
import { sectionIds } from '../../notation/sections.ts';
import { type SymbolId, symbol, thingAlong } from '../../notation/symbols.ts';
import { Formula } from './formula.tsx';

/** The card of the symbol that is pointed at, if one is. To be put on the page once. */
export function SymbolCard() {
  const place = pointed.value;
  const [id] = highlighted.value.symbols;
  return place?.hook.dataset.sym && id ? <Card id={id} {...place} /> : null;
}

/** What a symbol is: name, meaning, shape, unit, present value, and where the lesson introduces it. Beside the place that was pointed at. */
function Card({ id, hook, by }: { id: SymbolId } & Pointed) {
  const card = useRef<HTMLDivElement>(null);
  const { unit, code, section, definition } = symbol(id);

  useLayoutEffect(() => {
    const place = () => {
      if (card.current) placeBeside(card.current, hook);
    };
    place();
    document.addEventListener('scroll', place, { capture: true, passive: true });
    return () => document.removeEventListener('scroll', place, { capture: true });
  });

  useLayoutEffect(() => {
    const enter = (event: MouseEvent) => {
      if (event.detail === 0) card.current?.querySelector('a')?.focus(); // pressed with a key
    };
    hook.addEventListener('click', enter as EventListener);
    return () => hook.removeEventListener('click', enter as EventListener);
  }, [hook]);

  // The card stands at the end of the page, its hook in the midst of it: Tab goes on from the hook, Escape returns there.
  const onKeyDown = (event: KeyboardEvent) => {
    if (event.key !== 'Tab' && event.key !== 'Escape') return;
    if (event.shiftKey) event.preventDefault();
    hook.focus();
  };

  return (
    <div
      ref={card}
      id={cardId}
      role="dialog"
      aria-label={t(`symbols.name.${id}`)}
      class="symbol-card"
      data-by={by}
      onKeyDown={onKeyDown}
    >
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
        <dd>{shapeText(id)}</dd>
        <dt>{t('equations.card.unit')}</dt>
        <dd>{unit ?? t('equations.card.dimensionless')}</dd>
        <dt>{t('equations.card.code')}</dt>
        <dd>
          <code>{code}</code>
        </dd>
        <PresentValue id={id} />
      </dl>
      <a href={`#/lesson/${section}`}>
        {t('equations.card.lesson', {
          number: sectionIds.indexOf(section) + 1,
          title: t(`symbols.section.${section}`),
        })}
      </a>
    </div>
  );
}

function shapeText(id: SymbolId): string {
  const { figure } = highlighted.value;
  const { shape } = symbol(id);
  if (shape.length === 0) return t('equations.card.number');
  const counted = shape.join(' × ');
  const size = figure && sizeOf(id, figure);
  return size === null || size === counted ? counted : `${counted} = ${size}`;
}

function PresentValue({ id }: { id: SymbolId }) {
  const { figure } = highlighted.value;
  if (!figure) return null;
  const at = litThings(figure);
  const value = symbolValue(id, figure, at);
  if (value === null) return null;
  const [rows] = symbol(id).shape;
  const thing = rows && thingAlong(rows);
  return (
    <>
      <dt>
        {thing === 'spring'
          ? t('equations.local.spring', { index: at.spring })
          : thing === 'vertex'
            ? t('equations.global.vertex', { index: at.vertex })
            : t('equations.card.value')}
      </dt>
      <dd>{value}</dd>
    </>
  );
}

/**
 * Above the hook where there is room, else below; always inside the window, and touching the hook, so that a mouse can reach the card. A hook
 * that has left the page or the window takes its card with it.
 */
function placeBeside(card: HTMLElement, hook: Hook): void {
  const margin = 8; // px
  const at = hook.getBoundingClientRect();
  if (!hook.isConnected || at.bottom < 0 || at.top > window.innerHeight) {
    pointAway();
    return;
  }
  const { width, height } = card.getBoundingClientRect();
  const left = Math.min(at.left + at.width / 2 - width / 2, window.innerWidth - width - margin);
  const top = at.top - height >= margin ? at.top - height : Math.min(at.bottom, window.innerHeight - height - margin);
  card.style.left = `${Math.max(margin, left)}px`;
  card.style.top = `${Math.max(margin, top)}px`;
}
