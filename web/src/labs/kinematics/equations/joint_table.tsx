import type { ComponentChildren } from 'preact';
import { inLanguage } from '../../../app/messages/in_language.ts';
import { fillTemplate } from '../../../lib/fill_template.ts';
import { en } from './en.ts';
import { jointHooks } from './joint_hooks.ts';
import { zh } from './zh.ts';

export interface JointRow {
  joint: number;
  cells: readonly ComponentChildren[];
}

interface Props {
  caption: string;
  /** Of the first column: the unit. */
  corner: string;
  columns: readonly ComponentChildren[];
  rows: readonly JointRow[];
  /** The joint that is looked at, and how to look at another; without it rows cannot be chosen. */
  chosen?: number;
  onChoose?: (joint: number) => void;
}

/** Numbers of joints, a row each, that light the joint in the picture. */
export function JointTable({ caption, corner, columns, rows, chosen, onChoose }: Props) {
  const words = inLanguage({ en, zh });
  return (
    <table class="vector-table joint-table">
      <caption class="visually-hidden">{caption}</caption>
      <thead>
        <tr>
          <td>{corner}</td>
          {columns.map((column, at) => (
            <th key={at} scope="col">
              {column}
            </th>
          ))}
        </tr>
      </thead>
      <tbody>
        {rows.map(({ joint, cells }) => (
          <tr key={joint} {...jointHooks(joint)}>
            <th scope="row">
              {onChoose ? (
                <button
                  type="button"
                  aria-pressed={joint === chosen}
                  aria-label={fillTemplate(words.joint, { joint })}
                  onClick={() => onChoose(joint)}
                >
                  {joint}
                </button>
              ) : (
                joint
              )}
            </th>
            {cells.map((cell, at) => (
              <td key={at}>{cell}</td>
            ))}
          </tr>
        ))}
      </tbody>
    </table>
  );
}
