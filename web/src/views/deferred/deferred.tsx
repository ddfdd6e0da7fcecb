import type { ComponentType } from 'preact';
import { useEffect, useState } from 'preact/hooks';
import { t } from '../../app/messages/index.ts';
import { Obstacle } from '../../app/obstacle.ts';

interface Props {
  /** The same function for the same content. */
  load: () => Promise<ComponentType>;
}

/** Content whose code comes when it is first shown; the reason, where it does not come. */
export function Deferred({ load }: Props) {
  const [loaded, setLoaded] = useState<{ Content: ComponentType } | Obstacle | null>(null);

  useEffect(() => {
    let wanted = true;
    const show = (next: { Content: ComponentType } | Obstacle) => {
      if (wanted) setLoaded(next);
    };
    load().then(
      (Content) => show({ Content }),
      (reason: unknown) =>
        show(reason instanceof Obstacle ? reason : new Obstacle('page.errors.unexpected', { reason: String(reason) })),
    );
    return () => {
      wanted = false;
      setLoaded(null);
    };
  }, [load]);

  if (!loaded) return <p class="obstacle">{t('page.loading')}</p>;
  if ('Content' in loaded) return <loaded.Content />;
  return (
    <p class="obstacle" role="alert">
      {t(loaded.key, loaded.params)}
    </p>
  );
}
