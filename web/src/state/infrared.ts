/** The reflectances in the infrared of materials and of surfaces with a label, 0 to 1, by name. */
export type Reflectances = readonly (readonly [name: string, reflectance: number])[];

/** The parts of the id of a scene: its own, its reflectances, and the posture of its robot or its time code. */
const PARTS = /^([^;~@]*)(?:;([^~@]*))?(.*)$/s;

/** Returns the reflectances that the id of a scene has: those of `first;floor=0.5;wood=0.2~1.2`. */
export function reflectances(scene: string): Reflectances {
  const text = PARTS.exec(scene)?.[2];
  if (!text) return [];
  return text.split(";").map((one) => {
    const place = one.lastIndexOf("=");
    return [decoded(one.slice(0, place)), Number(one.slice(place + 1))] as const;
  });
}

/** Returns the id of the scene with other reflectances. */
export function reflecting(scene: string, all: Reflectances): string {
  const [, own = "", , state = ""] = PARTS.exec(scene) ?? [];
  return own + all.map(([name, value]) => `;${encodeURIComponent(name).replaceAll("~", "%7E")}=${value}`).join("") + state;
}

/** A name in a link may be damaged. */
function decoded(name: string): string {
  try {
    return decodeURIComponent(name);
  } catch {
    return name;
  }
}
