interface Props {
  kinds: readonly { colours: readonly string[]; name: string }[];
}

/** What the colours of a matrix mean. */
export function KindLegend({ kinds }: Props) {
  return (
    <ul class="kind-legend">
      {kinds.map(({ colours, name }) => (
        <li key={name}>
          <span class="kind-swatch">
            {colours.map((colour) => (
              <span key={colour} style={{ background: `var(${colour})` }} />
            ))}
          </span>
          {name}
        </li>
      ))}
    </ul>
  );
}
