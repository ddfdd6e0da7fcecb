import { fillTemplate } from '../lib/fill_template.ts';

/** What can be wrong with a scene's files, in English. A translation is another table with these keys. */
export const sceneMessages = {
  in_file: '{{file}}: {{problem}}',
  at_line: '{{file}} line {{line}}: {{problem}}',
  at_field: '{{file}} {{field}}: {{problem}}',

  unreadable_file: 'cannot read {{value}}',
  not_json: 'column {{column}}: not JSON from {{value}} on',
  json_ends_early: 'column {{column}}: the JSON ends too early',
  missing: 'this field is missing',
  empty: 'this text is empty',
  not_an_object: '{{value}} is not an object in braces',
  not_a_list: '{{value}} is not a list',
  not_a_text: '{{value}} is not a text in quotes',
  not_a_number: '{{value}} is not a finite number',
  not_a_whole_number: '{{value}} is not a whole number',
  not_positive: '{{value}} is not positive',
  too_small: '{{value}} is less than {{minimum}}',
  too_large: '{{value}} is more than {{maximum}}',

  no_shape: 'either "obj" or "mesh" is needed: the file of the vertices',
  two_shapes: '"obj" and "mesh" are both given: only one can be the file of the vertices',

  too_few_numbers: 'has {{value}} numbers of {{minimum}}',
  too_few_vertices: 'joins fewer than {{minimum}} vertices',
  not_an_index: '{{value}} is not a vertex number',
  vertex_out_of_range: 'vertex {{value}} of {{count}}',
  texture_vertex_out_of_range: 'texture vertex {{value}} of {{count}}',
  self_spring: 'vertex {{value}} is joined to itself',
  too_many_vertices: '{{value}} vertices are more than {{maximum}}',
  too_many_springs: 'there are more than {{maximum}} springs',
  no_vertices: 'there are no vertices',
  no_springs: 'there are no springs',

  not_a_mesh: 'does not begin with MeshVersionFormatted, as a Medit mesh in text form does',
  not_in_space: 'Dimension is {{value}} instead of 3',
  not_a_section: '{{value}} stands where the name of a section should',
  too_few_rows: '{{section}} ends after {{value}} of {{count}} rows',

  duplicate_pin: 'vertex {{value}} is pinned twice',
  no_mass: 'this field is missing, and vertex {{value}} is in no triangle whose area could give it one',
  no_mass_of_solid: 'this field is missing, and vertex {{value}} is in no tetrahedron whose volume could give it one',
  no_texture_coordinates: '{{value}} lacks texture coordinates on some corner',
};

export type SceneMessages = typeof sceneMessages;
export type SceneErrorCode = Exclude<keyof SceneMessages, 'in_file' | 'at_line' | 'at_field'>;

/** A file at fault, and where in it: a line of text, or a field such as "b[2]". */
export type Place = { file: string } | { file: string; line: number } | { file: string; field: string };

/** What is wrong, where, and the values that the sentence needs. */
export interface SceneError {
  code: SceneErrorCode;
  place: Place;
  params: Record<string, string | number>;
}

/** A SceneError whose place the caller knows. */
export type Problem = Omit<SceneError, 'place'>;

export function isSceneError(result: object): result is SceneError {
  return 'code' in result;
}

/** One line, e.g. "net.obj line 17: vertex 12 of 10". */
export function describeSceneError(
  { code, place, params }: SceneError,
  messages: SceneMessages = sceneMessages,
): string {
  const where = 'line' in place ? messages.at_line : 'field' in place ? messages.at_field : messages.in_file;
  return fillTemplate(where, { ...place, problem: fillTemplate(messages[code], params) });
}
