import { t } from '../../app/messages/index.ts';
import { CodeListing } from '../../views/code/code_listing.tsx';
import type { SourceFile } from '../../views/code/sources.ts';

/** The functions that compute an equation, folded away. */
export function InCode({ files }: { files: readonly SourceFile[] }) {
  return (
    <details class="in-code">
      <summary>{t('code.fold')}</summary>
      <p>{t('code.plain')}</p>
      {files.map((file) => (
        <CodeListing key={file} file={file} />
      ))}
    </details>
  );
}
