import type { Actions } from '../../app/actions.ts';
import { t } from '../../app/messages/index.ts';
import { route } from '../../app/route.ts';
import { librarySceneNames, openedScenes } from '../../app/scene_library.ts';
import { state } from '../../app/state.ts';

/** Which scene is simulated: one of the library, or the reader's own files. */
export function SceneMenu({ actions }: { actions: Actions }) {
  const chosen = () => (route.value.page === 'integrators' ? state.value.integrators.scene : state.value.scene);
  return (
    <div class="scene-menu">
      <label>
        <span class="scene-menu-name">{t('page.controls.scene')}</span>{' '}
        <select
          value={chosen()}
          onChange={async ({ currentTarget }) => {
            await actions.openScene(currentTarget.value);
            currentTarget.value = chosen(); // another one, when it was refused or given up
          }}
        >
          {librarySceneNames.map((name) => (
            <option key={name} value={name}>
              {t(`page.scenes.${name}`)}
            </option>
          ))}
          {openedScenes.value.map(({ name }) => (
            <option key={name} value={name}>
              {name}
            </option>
          ))}
        </select>
      </label>
      <label class="button" title={t('page.controls.openFilesHint')}>
        {t('page.controls.openFiles')}
        <input
          type="file"
          class="visually-hidden"
          multiple
          accept=".json,.obj,.mesh,.png"
          onChange={(event) => {
            void actions.openFiles([...(event.currentTarget.files ?? [])]);
            event.currentTarget.value = ''; // or the same file could not be chosen twice
          }}
        />
      </label>
    </div>
  );
}
