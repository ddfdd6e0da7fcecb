import type { Actions } from '../../../app/actions.ts';
import { kinematicsLimits, type Link } from '../../../app/kinematics.ts';
import { inLanguage } from '../../../app/messages/in_language.ts';
import { state } from '../../../app/state.ts';
import { fillTemplate } from '../../../lib/fill_template.ts';
import { Icon } from '../../../lib/icon.tsx';
import { NumberField } from '../../../views/controls/number_field.tsx';
import { jointHooks } from '../equations/joint_hooks.ts';
import { en } from './en.ts';
import { zh } from './zh.ts';

/** Every link's length and how far it may bend; links are added at the end effector. */
export function LinkList({ actions }: { actions: Actions }) {
  const words = inLanguage({ en, zh }).links;
  const { links } = state.value.kinematics;
  const { min: fewest, max: most } = kinematicsLimits.links;
  const change = (at: number, part: Partial<Link>) =>
    actions.setKinematics({ links: links.map((link, other) => (other === at ? { ...link, ...part } : link)) });
  const remove = (at: number, button: HTMLElement) => {
    // The last row goes, and the keyboard must not go with it.
    if (at === links.length - 1) button.closest('li')?.previousElementSibling?.querySelector('button')?.focus();
    actions.setKinematics({ links: links.filter((_, other) => other !== at) });
  };
  return (
    <div class="link-list">
      <p class="link-heads" aria-hidden="true">
        <span>{words.link}</span>
        <span>{words.length}</span>
        <span>{words.bend}</span>
      </p>
      <ol>
        {links.map(({ length, bend }, at) => (
          <li key={at} {...jointHooks(at)}>
            <span>{fillTemplate(words.between, { from: at, to: at + 1 })}</span>
            <label class="visually-hidden" for={`link-length-${at}`}>
              {fillTemplate(words.lengthOf, { from: at, to: at + 1 })}
            </label>
            <NumberField
              id={`link-length-${at}`}
              value={length}
              {...kinematicsLimits.length}
              unit="m"
              onSet={(next) => change(at, { length: next })}
            />
            <label class="visually-hidden" for={`link-bend-${at}`}>
              {fillTemplate(words.bendOf, { joint: at })}
            </label>
            <NumberField
              id={`link-bend-${at}`}
              value={bend}
              {...kinematicsLimits.bend}
              unit="°"
              onSet={(next) => change(at, { bend: next })}
              onClear={() => change(at, { bend: null })}
            />
            <button
              type="button"
              class="quiet"
              aria-label={fillTemplate(words.remove, { from: at, to: at + 1 })}
              title={fillTemplate(words.remove, { from: at, to: at + 1 })}
              aria-disabled={links.length === fewest}
              onClick={({ currentTarget }) => links.length > fewest && remove(at, currentTarget)}
            >
              <Icon name="close" />
            </button>
          </li>
        ))}
      </ol>
      <p class="settings-note">{words.bendHint}</p>
      <button
        type="button"
        aria-disabled={links.length === most}
        onClick={() =>
          links.length < most && actions.setKinematics({ links: [...links, { length: newLength, bend: null }] })
        }
      >
        {words.add}
      </button>
    </div>
  );
}

/** m: of a link that is added. */
const newLength = 0.3;
