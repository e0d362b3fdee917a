import type { Parameter } from "../protocol";
import { minus, typed } from "../util/format";

/** The result of reading the text of a field. */
export type Checked = { text: string } | { problem: string };

/** Checks what somebody typed for a parameter; a problem is a sentence for the field. */
export function check(parameter: Parameter, entered: string): Checked {
  const text = entered.trim();
  if (parameter.type === "boolean") {
    return text === "true" || text === "false" ? { text } : { problem: "Enter true or false." };
  }
  if (parameter.choices) {
    return parameter.choices.includes(text) ? { text } : { problem: `Choose one of ${parameter.choices.join(", ")}.` };
  }
  if (parameter.type === "string") return { text };
  const value = Number(typed(text));
  if (text === "" || !Number.isFinite(value)) return { problem: "Enter a number." };
  if (parameter.type === "integer" && !Number.isInteger(value)) return { problem: "Enter a whole number." };
  const { minimum, maximum, step } = parameter;
  if (step !== null && (value - (minimum ?? 0)) % step !== 0) return { problem: `Enter ${range(parameter)}.` };
  if ((minimum !== null && value < minimum) || (maximum !== null && value > maximum)) {
    return { problem: `Enter ${range(parameter)}.` };
  }
  return { text: typed(text) };
}

/** Describes the values that a parameter may have, such as "0 to 100 px". */
export function range(parameter: Parameter): string {
  return parameter.choices ? parameter.choices.join(", ") : minus(limits(parameter));
}

function limits({ type, minimum, maximum, step, unit }: Parameter): string {
  // The smallest number that a computer can hold means that 0 itself is excluded.
  const isPositive = minimum !== null && minimum > 0 && minimum < 1e-300;
  if (type === "boolean") return "true or false";
  const suffix = unit ? ` ${unit}` : "";
  if (step !== null && minimum !== null && maximum !== null) return `${minimum}, ${minimum + step}, … ${maximum}${suffix}`;
  if (isPositive) return maximum === null ? `more than 0${suffix}` : `more than 0, at most ${maximum}${suffix}`;
  if (minimum !== null && maximum !== null) return `${minimum} to ${maximum}${suffix}`;
  if (minimum !== null) return `at least ${minimum}${suffix}`;
  if (maximum !== null) return `at most ${maximum}${suffix}`;
  return `any number${suffix}`;
}

/** A slider reaches this many times as far as the default where the range is much wider or has no end. */
const USEFUL = 4;

/** Returns the limits of a slider, or null if a parameter has none that a slider could use. `reach` shortens its range. */
export function slider(parameter: Parameter, fallback: number, reach = 1): { from: number; to: number; step: number } | null {
  if (parameter.type !== "number" && parameter.type !== "integer") return null;
  if (parameter.choices || !Number.isFinite(fallback)) return null;
  if (parameter.typical) {
    // A device may have a default outside the usual range.
    const [from, to] = [Math.min(parameter.typical[0], fallback), Math.max(parameter.typical[1], fallback)];
    return { from, to, step: parameter.step ?? (parameter.type === "integer" ? 1 : 10 ** Math.floor(Math.log10((to - from) / 200))) };
  }
  const lowest = (parameter.minimum ?? Math.min(0, USEFUL * fallback)) * reach;
  const highest = (parameter.maximum ?? Math.max(0, USEFUL * fallback)) * reach;
  const size = Math.abs(fallback - lowest);
  const isWide = size > 0 && highest - lowest > 3 * USEFUL * size;
  const to = isWide ? Number((lowest + USEFUL * size).toPrecision(2)) : highest;
  if (to <= lowest) return null;
  const step = parameter.step ?? (parameter.type === "integer" ? 1 : 10 ** Math.floor(Math.log10((to - lowest) / 200)));
  // An excluded end, such as 0 for a length, is left out.
  const from = lowest > 0 && lowest < step ? step : lowest;
  return { from, to, step };
}

/** Groups parameters under their headings, in order of appearance. */
export function grouped(parameters: Parameter[]): [string, Parameter[]][] {
  const groups = new Map<string, Parameter[]>();
  for (const parameter of parameters) {
    const group = groups.get(parameter.group);
    if (group) group.push(parameter);
    else groups.set(parameter.group, [parameter]);
  }
  return [...groups];
}
