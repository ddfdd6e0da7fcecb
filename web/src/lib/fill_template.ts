/** `template` with every `{{name}}` replaced by `params.name`: the notation of the message catalogues. */
export function fillTemplate(template: string, params: Record<string, string | number>): string {
  return template.replace(/\{\{(\w+)\}\}/g, (_, name: string) => String(params[name]));
}
