/** How a chart draws its so-maniest curve. */
export function Swatch({ curve }: { curve: number }) {
  return (
    <svg width="28" height="10" aria-hidden="true" class={`curve curve-${curve}`}>
      <path d="M0 5H28" />
    </svg>
  );
}
