import { useRef, useState } from 'preact/hooks';
import { t } from '../../app/messages/index.ts';
import { cardId } from '../../app/pointing.ts';
import { moveInGrid } from '../../lib/move_in_grid.ts';
import { linesOf, rangeOfPart, type SourceFile, symbolNamed } from './sources.ts';
import { tokenize } from './tokenize.ts';
import './code.css';

interface Props {
  file: SourceFile;
  /** One function of it alone. */
  name?: string;
  /** Numbers of lines to mark, from 0. */
  marked?: ReadonlySet<number>;
}

/** Of the solver's own source, with its symbols linked. One tab stop: arrows go from line to line, and in a line from symbol to symbol. */
export function CodeListing({ file, name, marked }: Props) {
  const list = useRef<HTMLOListElement>(null);
  const { first, end } = name === undefined ? { first: 0, end: undefined } : rangeOfPart({ file, name });
  const [current, setCurrent] = useState(0);

  const onKeyDown = (event: KeyboardEvent) => {
    const lines = Array.from((list.current as HTMLOListElement).children, (line) => [
      ...line.querySelectorAll('button'),
    ]);
    const row = lines.findIndex((line) => line.includes(event.target as HTMLButtonElement));
    const column = lines[row].indexOf(event.target as HTMLButtonElement);
    const next = moveInGrid(
      event.key,
      { row, column },
      lines.map((line) => line.length),
    );
    if (!next) return;
    setCurrent(next.row);
    lines[next.row][next.column].focus();
    event.preventDefault();
    event.stopPropagation(); // here arrows move the focus, not the cursor in time
  };

  return (
    <figure class="code-listing">
      <figcaption>wasm/core/{file}</figcaption>
      <ol ref={list} aria-label={t('code.listing', { file })} onKeyDown={onKeyDown}>
        {linesOf(file)
          .slice(first, end)
          .map((line, row) => (
            <Line
              key={`${row} ${line}`}
              file={file}
              number={first + row + 1}
              line={line}
              isTabStop={row === current}
              isMarked={marked?.has(first + row) ?? false}
            />
          ))}
      </ol>
    </figure>
  );
}

interface LineProps {
  file: SourceFile;
  number: number;
  line: string;
  isTabStop: boolean;
  isMarked: boolean;
}

function Line({ file, number, line, isTabStop, isMarked }: LineProps) {
  const tokens = tokenize(line).map((token) => ({
    ...token,
    symbol: token.kind === 'name' ? symbolNamed(token.text, file) : undefined,
  }));
  const symbols = new Set(tokens.flatMap(({ symbol }) => symbol ?? []));
  return (
    <li
      data-about={[...symbols].join(' ')}
      data-line={`${file} ${number}`}
      class={isMarked ? 'code-marked' : undefined}
    >
      <button
        type="button"
        class="code-line"
        tabIndex={isTabStop ? 0 : -1}
        aria-label={t('code.line', { number, line })}
        aria-haspopup={symbols.size > 0 ? 'dialog' : undefined}
        aria-describedby={symbols.size > 0 ? cardId : undefined}
      >
        {number}
      </button>
      {tokens.map(({ kind, text, symbol }, at) =>
        symbol ? (
          <button
            key={at}
            type="button"
            class="code-symbol"
            data-sym={symbol}
            tabIndex={-1}
            aria-haspopup="dialog"
            aria-describedby={cardId}
          >
            {text}
          </button>
        ) : (
          <span key={at} class={`code-${kind}`}>
            {text}
          </span>
        ),
      )}
    </li>
  );
}
