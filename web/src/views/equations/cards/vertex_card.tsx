import { t } from '../../../app/messages/index.ts';
import type { VertexFacts } from '../../../app/thing_facts.ts';
import { formatQuantity, formatVector } from '../../../lib/format.ts';
import { Formula } from '../formula.tsx';
import { Facts } from './facts.tsx';
import { headFact, type MatrixHead } from './head_fact.ts';
import { LessonLink } from './lesson_link.tsx';

const { raw } = String;

interface Props {
  name: string;
  vertex: number;
  facts: VertexFacts;
  head: MatrixHead | null;
}

/** A vertex at present: where it is and was, its mass, whether it is held, and its row of Q p = b where the page knows it. */
export function VertexCard({ name, vertex, facts: { p, pCurr, mass, springs, target, equation }, head }: Props) {
  return (
    <>
      <p class="card-name">
        <strong>{name}</strong>{' '}
        <span>
          {target ? t('equations.card.vertex.pinned') : t('equations.card.vertex.springs', { count: springs })}
        </span>
      </p>
      <Facts
        facts={[
          head && headFact(head),
          [<Formula key="p" tex={raw`\symp_{${vertex}}`} />, formatVector(p, 'm')],
          [<Formula key="p_curr" tex={raw`\sympCurr_{${vertex}}`} />, formatVector(pCurr, 'm')],
          target && [t('equations.card.vertex.held'), formatVector(target, 'm')],
          [t('symbols.name.m'), formatQuantity(mass, 'kg')],
          equation && [<Formula key="Qp" tex={raw`(\symQ\symp)_{${vertex}}`} />, formatVector(equation.Qp, 'N')],
          equation && [<Formula key="b" tex={raw`\symb_{${vertex}}`} />, formatVector(equation.b, 'N')],
        ]}
      />
      <LessonLink section={target ? 'pins' : 'model'} />
    </>
  );
}
