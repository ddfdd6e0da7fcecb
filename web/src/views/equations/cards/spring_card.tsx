import { t } from '../../../app/messages/index.ts';
import type { SpringFacts } from '../../../app/thing_facts.ts';
import { formatLength, formatQuantity, formatVector } from '../../../lib/format.ts';
import { Formula } from '../formula.tsx';
import { strainText } from '../strain_text.ts';
import { Facts } from './facts.tsx';
import { headFact, type MatrixHead } from './head_fact.ts';
import { LessonLink } from './lesson_link.tsx';

const { raw } = String;

interface Props {
  name: string;
  facts: SpringFacts;
  head: MatrixHead | null;
}

/** A spring at present: its ends, how long it should be and is, its projection, and how hard it pulls. */
export function SpringCard({ name, facts: { i, j, r, length, strain, d, pull }, head }: Props) {
  return (
    <>
      <p class="card-name">
        <strong>{name}</strong> <span>{t('equations.card.spring.ends', { i, j })}</span>
      </p>
      <Facts
        facts={[
          head && headFact(head),
          [
            <>
              {t('equations.card.spring.rest')} <Formula tex={raw`\symr_{ij}`} />
            </>,
            formatLength(r),
          ],
          [
            <>
              {t('equations.card.spring.length')} <Formula tex={raw`\lVert \symp_i - \symp_j \rVert`} />
            </>,
            <>
              {formatLength(length)} <span>{strainText(strain)}</span>
            </>,
          ],
          d && [<Formula key="d" tex={raw`\symd_{ij}`} />, formatVector(d, 'm')],
          [t(`equations.card.spring.${pull < 0 ? 'pushes' : 'pulls'}`), formatQuantity(Math.abs(pull), 'N')],
        ]}
      />
      <LessonLink section="model" />
    </>
  );
}
