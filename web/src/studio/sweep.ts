import type { OakState, PoseCoverage } from "../protocol";
import { moved, toAngles, turned, type UpAxis } from "../util/pose";

/** From, to and the number of values. */
export interface Span {
  from: number;
  to: number;
  count: number;
}

/** The state of one of the page's OAKs. */
export interface Placed {
  /** {@link Oak.key}. */
  key: string;
  state: OakState;
}

/** A pose of a sweep with what it covers. */
export interface Ranked extends Placed {
  heightM: number;
  tiltDeg: number;
  coverage: PoseCoverage;
}

/** More poses than this would take minutes. */
export const MAX_POSES = 60;

function values({ from, to, count }: Span): number[] {
  if (count <= 1) return [from];
  return Array.from({ length: count }, (_, i) => from + ((to - from) * i) / (count - 1));
}

export function height(state: OakState, up: UpAxis): number {
  return state.pose.position[up === "z" ? 2 : 1];
}

/** Returns the states of OAKs at all heights and tilts. */
export function sweep(oaks: Placed[], heights: Span, tilts: Span, up: UpAxis): Placed[] {
  return oaks.flatMap(({ key, state }) => values(heights).flatMap((metres) => values(tilts).map((degrees) => {
    const raised = moved(state.pose, [0, 0, metres - height(state, up)], up);
    const pose = turned(raised, { pitch: degrees - toAngles(raised.quaternion, up).pitch }, up);
    return { key, state: { ...state, pose } };
  })));
}

/** Ranks poses: those that measure more of the region come first, and of equal ones those with the smaller error. */
export function rank(oaks: Placed[], poses: PoseCoverage[], up: UpAxis): Ranked[] {
  const ranked = oaks.flatMap(({ key, state }, i): Ranked[] => {
    const coverage = poses[i];
    return coverage ? [{ key, state, heightM: height(state, up), tiltDeg: toAngles(state.pose.quaternion, up).pitch, coverage }] : [];
  });
  const error = ({ coverage }: Ranked) => coverage.medianAbsoluteErrorM ?? Number.POSITIVE_INFINITY;
  return ranked.sort((a, b) => b.coverage.measured - a.coverage.measured || error(a) - error(b));
}
