import type { SceneInfo, Vec3 } from "../protocol";
import type { UpAxis } from "../util/pose";

/** How a mesh file that does not say is read. */
export interface Units {
  /** Metres per unit. */
  scale: number;
  up: UpAxis;
}

export const UNITS: { scale: number; title: string }[] = [
  { scale: 1, title: "metres" },
  { scale: 0.01, title: "centimetres" },
  { scale: 0.001, title: "millimetres" },
  { scale: 0.0254, title: "inches" },
  { scale: 0.3048, title: "feet" },
];

/** A file with a larger side than this is hardly in metres: STL, OBJ and PLY come from CAD and scanners; the unit of glTF is the metre. */
const LARGEST_IN_METRES = 50;
const LARGEST_GLTF = 1000;
/** A side that begins this near to 0, as a share of its length, stands on the ground. */
const GROUND = 0.01;

/** Guesses how a file is to be read; `info` is the file read with 1 metre per unit and the up axis of its format. */
export function guessUnits({ name, bounds, up }: SceneInfo): Units {
  const [low, high] = bounds;
  const size = sides(bounds);
  const isGltf = /\.(gltf|glb)$/i.test(name);
  const scale = Math.max(...size) >= (isGltf ? LARGEST_GLTF : LARGEST_IN_METRES) ? 0.001 : 1;
  // glTF files that are not y-up are rare: the format demands it.
  if (isGltf) return { scale, up };
  const isGround = (axis: 1 | 2) => size[axis] > 0 && Math.abs(low[axis]) < GROUND * size[axis] && high[axis] > 0;
  if (isGround(1) === isGround(2)) return { scale, up };
  return { scale, up: isGround(1) ? "y" : "z" };
}

export function sides([low, high]: [Vec3, Vec3]): Vec3 {
  return [high[0] - low[0], high[1] - low[1], high[2] - low[2]];
}

/** Says why a unit was guessed. */
export function reasonFor({ scale, up }: Units, info: SceneInfo): string {
  const largest = Math.max(...sides(info.bounds));
  const unit = scale === 1
    ? `The largest side has ${number(largest)} units, which suits metres.`
    : `The largest side has ${number(largest)} units; as metres that would be ${number(largest)} m.`;
  return up === info.up ? unit : `${unit} The ${up} axis begins at the ground.`;
}

function number(value: number): string {
  return Number(value.toPrecision(3)).toLocaleString("en");
}
