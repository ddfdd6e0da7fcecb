import { fillTemplate } from '../lib/fill_template.ts';
import type { Status, StatusCode } from './module.ts';

const sentences: Record<StatusCode, string> = {
  ok: 'no error',
  no_scene: 'no scene has been set',
  no_vertices: 'there are no vertices',
  wrong_length: 'a length of {{value}} does not fit',
  not_finite: '{{value}} is not a finite number',
  index_out_of_range: 'there is no {{indexed}} {{value}}',
  self_spring: 'vertex {{value}} is joined to itself',
  duplicate_spring: 'the spring of row {{value}} again',
  duplicate_vertex: 'the vertex of row {{value}} again',
  not_positive: '{{value}} is not positive',
  negative: '{{value}} is negative',
  too_stiff: 'the stiffness number Σk·Δt²/m is {{value}}, and beyond {{limit}} double precision is lost',
  too_large: '{{value}} bytes are more than the {{limit}} that the solver takes',
  factorisation_failed: 'Q is not positive definite to machine precision',
  diverged: 'became {{value}} in this time step',
  on_root: 'lies on the root, so that no direction leads to it',
  unstable: 'left its stable region: Δt·ω = {{value}} > {{limit}}',
};

/** One English line with field, row (from 0) and value, e.g. "E[3]: there is no vertex 12". */
export function describeStatus({ code, field, index, value, limit }: Status): string {
  const place = index < 0 ? field : `${field}[${index}]`;
  const indexed = field === 'half_step' ? 'half-step' : 'vertex';
  const sentence = fillTemplate(sentences[code], {
    value: code === 'unstable' ? Number(value.toPrecision(3)) : value,
    limit: code === 'unstable' ? Number(limit.toPrecision(3)) : limit,
    indexed,
  });
  return place ? `${place}: ${sentence}` : sentence;
}
