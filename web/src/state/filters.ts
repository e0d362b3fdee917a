/** A filter with those of its parameters that are not defaults. */
export interface FilterUse {
  name: string;
  parameters: Record<string, string>;
}

/** Reads "NAME" or "NAME:KEY=VALUE,…". */
export function parseFilter(text: string): FilterUse {
  const colon = text.indexOf(":");
  if (colon < 0) return { name: text, parameters: {} };
  const parameters: Record<string, string> = {};
  for (const pair of text.slice(colon + 1).split(",")) {
    const equals = pair.indexOf("=");
    if (equals > 0) parameters[pair.slice(0, equals).trim()] = pair.slice(equals + 1).trim();
  }
  return { name: text.slice(0, colon), parameters };
}

export function formatFilter({ name, parameters }: FilterUse): string {
  const pairs = Object.entries(parameters).map(([key, value]) => `${key}=${value}`);
  return pairs.length ? `${name}:${pairs.join(",")}` : name;
}
