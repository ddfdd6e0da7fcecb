const paths = {
  play: 'M7 4.5v15l12-7.5z',
  pause: 'M6 4.5h4v15H6zM14 4.5h4v15h-4z',
  reset: 'M12 5a7 7 0 1 1-6.6 4.7l1.9.7A5 5 0 1 0 12 7v3L7 6l5-4z',
  previousStep: 'M5 5h2.5v14H5zM19 5v14l-10-7z',
  nextStep: 'M16.5 5H19v14h-2.5zM5 5l10 7-10 7z',
  previousHalfStep: 'M15.5 5v14L6 12z',
  nextHalfStep: 'M8.5 5v14l9.5-7z',
  first: 'M4 5h2v14H4zM13 5v14l-7-7zM20 5v14l-7-7z',
  last: 'M18 5h2v14h-2zM4 5l7 7-7 7zM11 5l7 7-7 7z',
  close: 'M6.4 5 12 10.6 17.6 5 19 6.4 13.4 12 19 17.6 17.6 19 12 13.4 6.4 19 5 17.6 10.6 12 5 6.4z',
  fit: 'M4 4h6v2H6v4H4zM14 4h6v6h-2V6h-4zM4 14h2v4h4v2H4zM18 14h2v6h-6v-2h4z',
  undo: 'M9 6V2L3 8l6 6v-4h4a4 4 0 0 1 0 8H8v2h5a6 6 0 0 0 0-12z',
} as const;

export type IconName = keyof typeof paths;

/** A 24-unit glyph in the colour of the text. Purely visual: the control around it carries the name. */
export function Icon({ name }: { name: IconName }) {
  return (
    <svg class="icon" viewBox="0 0 24 24" width="1.25em" height="1.25em" fill="currentColor" aria-hidden="true">
      <path d={paths[name]} />
    </svg>
  );
}
