import type { CoverageAnswer, OakState } from "../protocol";
import { moved, toAngles, turned, type UpAxis } from "../util/pose";

/** From, to and the number of values. */
export interface Span {
  from: number;
  to: number;
  count: number;
}

/** A pose of a sweep with what it covers. */
export interface Ranked {
  state: OakState;
  heightM: number;
  tiltDeg: number;
  coverage: CoverageAnswer["poses"][number];
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
export function sweep(states: OakState[], heights: Span, tilts: Span, up: UpAxis): OakState[] {
  return states.flatMap((state) => values(heights).flatMap((metres) => values(tilts).map((degrees) => {
    const raised = moved(state.pose, [0, 0, metres - height(state, up)], up);
    const pose = turned(raised, { pitch: degrees - toAngles(raised.quaternion, up).pitch }, up);
    return { ...state, pose };
  })));
}

/** Ranks poses: those that measure more of the region come first, and of equal ones those with the smaller error. */
export function rank(states: OakState[], answer: CoverageAnswer, up: UpAxis): Ranked[] {
  const ranked = states.flatMap((state, i): Ranked[] => {
    const coverage = answer.poses[i];
    return coverage ? [{ state, heightM: height(state, up), tiltDeg: toAngles(state.pose.quaternion, up).pitch, coverage }] : [];
  });
  const error = ({ coverage }: Ranked) => coverage.medianAbsoluteErrorM ?? Number.POSITIVE_INFINITY;
  return ranked.sort((a, b) => b.coverage.measured - a.coverage.measured || error(a) - error(b));
}
