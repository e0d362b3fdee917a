/** What is shown for a value that does not exist. */
export const NONE = "–";

/** Formats a length with a unit that suits it. */
export function length(metres: number | null | undefined): string {
  if (metres == null || !Number.isFinite(metres)) return NONE;
  const size = Math.abs(metres);
  if (size < 0.001) return `${(metres * 1e3).toFixed(3)} mm`;
  if (size < 0.1) return `${(metres * 1e3).toFixed(1)} mm`;
  return `${metres.toFixed(3)} m`;
}

/** Formats an error: always in millimetres and with its sign. */
export function signedMillimetres(metres: number | null | undefined): string {
  const text = bareMillimetres(metres, true);
  return text === NONE ? NONE : `${text} mm`;
}

/** Formats a fraction as a percentage without its unit, for tables that name it. */
export function bareShare(fraction: number | null | undefined): string {
  return fraction == null || !Number.isFinite(fraction) ? NONE : (fraction * 100).toFixed(1);
}

/** Formats a length in millimetres without its unit, for tables that name it. */
export function bareMillimetres(metres: number | null | undefined, isSigned = false): string {
  if (metres == null || !Number.isFinite(metres)) return NONE;
  const text = Math.abs(metres * 1e3).toFixed(1);
  if (Number(text) === 0) return text;
  return `${metres < 0 ? "−" : isSigned ? "+" : ""}${text}`;
}

export function millimetres(metres: number | null | undefined): string {
  const text = bareMillimetres(metres);
  return text === NONE ? NONE : `${text} mm`;
}

export function share(fraction: number | null | undefined): string {
  if (fraction == null || !Number.isFinite(fraction)) return NONE;
  return `${(fraction * 100).toFixed(1)} %`;
}

/** Formats a number: at most `digits` decimals, no trailing zeros, and a minus sign that is no hyphen. */
export function decimal(value: number, digits: number): string {
  return minus(String(Number(value.toFixed(digits))));
}

/** Writes a number's hyphens as minus signs. */
export function minus(number: string): string {
  return number.replaceAll("-", "−");
}

/** Reads a number as somebody types it: with a decimal comma, or a minus sign. */
export function typed(text: string): string {
  return text.trim().replace(",", ".").replaceAll("−", "-");
}

/** Makes a heading of an identifier: "outside_view" and "outsideView" become "Outside view". */
export function words(name: string): string {
  const spaced = name
    .replace(/[_-]+/g, " ")
    .replace(/([a-z0-9])([A-Z])/g, (_, before: string, after: string) => `${before} ${after.toLowerCase()}`);
  return spaced.charAt(0).toUpperCase() + spaced.slice(1);
}

/** Keeps a name such as "OAK-D" on one line. */
export function unbroken(name: string): string {
  return name.replaceAll("-", "\u2011");
}

export function bytes(count: number): string {
  return count < 1e6 ? `${(count / 1e3).toFixed(0)} kB` : `${(count / 1e6).toFixed(0)} MB`;
}

/** Rounds up to 1, 2 or 5 times a power of ten, so that a scale ends at a round number. */
export function roundUp(value: number): number {
  if (!(value > 0)) return 0;
  const power = 10 ** Math.floor(Math.log10(value));
  const step = [1, 2, 5, 10].find((step) => value <= step * power * 1.0001) ?? 10;
  return Number((step * power).toPrecision(3));
}
