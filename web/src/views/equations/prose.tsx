import type { ComponentChildren } from 'preact';
import { Display } from './display.tsx';
import { Formula } from './formula.tsx';
import { type Block, parseProse, type Span } from './parse_prose.ts';
import './prose.css';

/** Characters of TeX: longer formulas may need to break on a phone. */
const longestUnbroken = 40;

/** Author's text (parse_prose.ts says in what notation) as the reader sees it. */
export function Prose({ text }: { text: string }) {
  return <>{parseProse(text).map((block, at) => renderBlock(block, at))}</>;
}

/** Author's text of one paragraph, for captions and cells. */
export function Phrase({ text }: { text: string }) {
  return <>{parseProse(text).map((block) => (block.kind === 'paragraph' ? renderSpans(block.spans) : null))}</>;
}

function renderBlock(block: Block, key: number): ComponentChildren {
  switch (block.kind) {
    case 'display':
      return <Display key={key} tex={block.tex} />;
    case 'list':
      return (
        <ul key={key}>
          {block.items.map((spans, item) => (
            <li key={item}>{renderSpans(spans)}</li>
          ))}
        </ul>
      );
    case 'paragraph':
      return <p key={key}>{renderSpans(block.spans)}</p>;
  }
}

function renderSpans(spans: readonly Span[]): ComponentChildren {
  return spans.map(renderSpan);
}

function renderSpan(span: Span, key: number): ComponentChildren {
  switch (span.kind) {
    case 'tex':
      return (
        <span key={key} class={span.text.length < longestUnbroken ? 'unbroken' : ''}>
          <Formula tex={span.text} />
          {span.after}
        </span>
      );
    case 'strong':
      return <strong key={key}>{renderSpans(span.spans)}</strong>;
    case 'code':
      return <code key={key}>{span.text}</code>;
    case 'link':
      return (
        <a key={key} href={`#/${span.path}`}>
          {span.text}
        </a>
      );
    case 'text':
      return span.text;
  }
}
