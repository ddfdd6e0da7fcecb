import type { SceneMessages } from '../../../scene/scene_error.ts';

export const scene: SceneMessages = {
  in_file: '{{file}}：{{problem}}',
  at_line: '{{file}} 第 {{line}} 行：{{problem}}',
  at_field: '{{file}} 的 {{field}}：{{problem}}',

  unreadable_file: '无法读取 {{value}}',
  not_json: '第 {{column}} 列：自 {{value}} 起不是 JSON',
  json_ends_early: '第 {{column}} 列：JSON 提前结束',
  missing: '缺少此字段',
  empty: '此文本为空',
  not_an_object: '{{value}} 不是花括号中的对象',
  not_a_list: '{{value}} 不是列表',
  not_a_text: '{{value}} 不是引号中的文本',
  not_a_number: '{{value}} 不是有限的数',
  not_a_whole_number: '{{value}} 不是整数',
  not_positive: '{{value}} 不是正数',
  too_small: '{{value}} 小于 {{minimum}}',
  too_large: '{{value}} 大于 {{maximum}}',

  no_shape: '缺少 "obj" 或 "mesh"：需指明质点所在的文件',
  two_shapes: '同时给出了 "obj" 和 "mesh"：质点只能来自其中一个文件',

  too_few_numbers: '应有 {{minimum}} 个数，只有 {{value}} 个',
  too_few_vertices: '连接的质点少于 {{minimum}} 个',
  not_an_index: '{{value}} 不是质点编号',
  vertex_out_of_range: '没有质点 {{value}}，共 {{count}} 个',
  texture_vertex_out_of_range: '没有纹理顶点 {{value}}，共 {{count}} 个',
  self_spring: '质点 {{value}} 与自身相连',
  too_many_vertices: '{{value}} 个质点超过了上限 {{maximum}}',
  too_many_springs: '弹簧超过 {{maximum}} 根',
  no_vertices: '没有质点',
  no_springs: '没有弹簧',

  not_a_mesh: '文件不以 MeshVersionFormatted 开头，不是文本格式的 Medit 网格',
  not_in_space: 'Dimension 为 {{value}}，应为 3',
  not_a_section: '此处应为一节的名称，却是 {{value}}',
  too_few_rows: '{{section}} 应有 {{count}} 行，只有 {{value}} 行',

  duplicate_pin: '质点 {{value}} 被固定了两次',
  no_mass: '缺少此字段，而质点 {{value}} 不属于任何三角形，无法由面积得到质量',
  no_mass_of_solid: '缺少此字段，而质点 {{value}} 不属于任何四面体，无法由体积得到质量',
  no_texture_coordinates: '{{value}} 的某些角缺少纹理坐标',
};
