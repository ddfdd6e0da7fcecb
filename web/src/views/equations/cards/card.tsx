import type { ComponentChildren } from 'preact';
import { entryAt } from '../../../app/entry_meaning.ts';
import { type Highlight, highlighted } from '../../../app/highlight.ts';
import { t } from '../../../app/messages/index.ts';
import { pointed } from '../../../app/pointing.ts';
import { springFacts, vertexFacts } from '../../../app/thing_facts.ts';
import { symbol } from '../../../notation/symbols.ts';
import { CardFrame } from './card_frame.tsx';
import { ColumnCard } from './column_card.tsx';
import { EntryCard, entryName } from './entry_card.tsx';
import { LineCard } from './line_card.tsx';
import { SpringCard } from './spring_card.tsx';
import { SymbolCard } from './symbol_card.tsx';
import { VertexCard } from './vertex_card.tsx';

/** The card of what is pointed at, if anything is. To be put on the page once. */
export function Card() {
  const at = pointed.value;
  const content = at && contentFor(highlighted.value);
  if (!content) return null;
  const { kind, name, body } = content;
  return (
    <CardFrame key={name} kind={kind} name={name} at={at}>
      {body}
    </CardFrame>
  );
}

interface Content {
  kind: 'symbol' | 'spring' | 'vertex' | 'entry' | 'column' | 'line';
  /** As read out. Another name is another card. */
  name: string;
  body: ComponentChildren;
}

/** The card that says most about what is pointed at: an entry is more than its spring, and a spring than the symbols it has rows of. */
function contentFor({ symbols, figure, spring, vertex, place, line }: Highlight): Content | null {
  const [id] = symbols;
  if (line) {
    if (!id) return null;
    return { kind: 'line', name: `${line.file}:${line.number}`, body: <LineCard line={line} symbols={symbols} /> };
  }
  if (id && place && figure) {
    const entry = entryAt(id, place, figure);
    if (entry) return { kind: 'entry', name: entryName(entry), body: <EntryCard entry={entry} figure={figure} /> };
  }
  const head = id && place ? { id, place } : null;
  const named = (name: string) => (head ? `${symbol(head.id).code}, ${name}` : name);
  if (figure && spring !== null) {
    const facts = springFacts(figure, spring);
    const name = t('equations.local.spring', { index: spring });
    return facts && { kind: 'spring', name: named(name), body: <SpringCard name={name} facts={facts} head={head} /> };
  }
  if (figure && vertex !== null) {
    const facts = vertexFacts(figure, vertex);
    const name = t('equations.global.vertex', { index: vertex });
    return (
      facts && {
        kind: 'vertex',
        name: named(name),
        body: <VertexCard name={name} vertex={vertex} facts={facts} head={head} />,
      }
    );
  }
  if (!id) return null;
  if (head && figure && head.place.column !== null) {
    const name = t('equations.card.column', { code: symbol(id).code, column: head.place.column });
    return { kind: 'column', name, body: <ColumnCard id={id} column={head.place.column} figure={figure} /> };
  }
  return { kind: 'symbol', name: t(`symbols.name.${id}`), body: <SymbolCard id={id} /> };
}
