import type { Frame } from "../net/wire";
import type { Display } from "../state/display";
import { roundUp } from "../util/format";

/** The ends of the colour scales that all panels share. */
export interface Scales {
  /** Metres. */
  depth: [number, number];
  /** Errors from minus this to this, metres or percent. */
  error: number;
}

/** How many pixels of an image are read to find its range. */
const SAMPLES = 4000;

const FALLBACK: Scales = { depth: [0, 5], error: 0.05 };

/** Finds the scales: those that were set, otherwise such that they suit all frames. */
export function findScales(frames: Iterable<Frame>, display: Display): Scales {
  const all = [...frames];
  return {
    depth: display.depthRange ?? depthRange(all),
    error: display.errorRange ?? errorEnd(all, display.errorUnit),
  };
}

function truth(frame: Frame) {
  return frame.pictures.get("reference") ?? frame.pictures.get("depth");
}

/** Returns the 1st and 99th percentile of the true depth, widened to round numbers so that the scale does not flicker. */
function depthRange(frames: Frame[]): [number, number] {
  const values: number[] = [];
  for (const frame of frames) {
    const data = truth(frame)?.data ?? frame.pictures.get("sensor")?.data;
    if (!data) continue;
    const stride = Math.max(1, Math.floor(data.length / SAMPLES));
    for (let i = 0; i < data.length; i += stride) if (data[i]) values.push(data[i] as number);
  }
  if (values.length === 0) return FALLBACK.depth;
  values.sort((a, b) => a - b);
  const at = (share: number) => (values[Math.floor(share * (values.length - 1))] as number) / 1000;
  const [near, far] = [at(0.01), at(0.99)];
  const step = Math.max(roundUp((far - near) / 20), 0.01);
  return [Number((Math.floor(near / step) * step).toFixed(3)), Number((Math.ceil(far / step) * step).toFixed(3))];
}

function errorEnd(frames: Frame[], unit: Display["errorUnit"]): number {
  const ends = frames.map(({ header: { statistics } }) => {
    if (unit === "mm") return statistics.p95AbsoluteErrorM ?? 0;
    return (statistics.medianAbsoluteErrorPercent ?? 0) * 3;
  });
  return roundUp(Math.max(0, ...ends)) || (unit === "mm" ? FALLBACK.error : 5);
}
