import type { SceneInfo, TrajectoryInfo } from "../protocol";

/** The frames of the timeline: the poses of a trajectory, or the times of an animated scene, or both at once. */
export interface Frames {
  count: number;
  /** The time code of frame 0 and the time codes from frame to frame; null if nothing in the scene moves. */
  codes: { first: number; step: number } | null;
  /** Returns the time of a frame in seconds. */
  timeOf(frame: number): number;
  /** Returns the last frame that is not after a time. */
  frameAt(seconds: number): number;
}

/** Returns the frames; null if nothing moves. */
export function framesOf(scene: SceneInfo | null, trajectory: TrajectoryInfo | null): Frames | null {
  const animation = scene?.animation ?? null;
  if (trajectory) {
    const times = trajectory.timesS;
    const count = times.length;
    const period = (times[count - 1] ?? 0) / Math.max(count - 1, 1);
    // A frame has one pose and one time code, as in `render --frames --trajectory`.
    const codes = animation && { first: animation.first, step: period > 0 ? period * animation.codesPerSecond : animation.step };
    return { count, codes, timeOf: (frame) => times[frame] ?? 0, frameAt: (seconds) => lastBefore(times, seconds) };
  }
  if (!animation) return null;
  const { first, last, step, codesPerSecond } = animation;
  const count = Math.floor((last - first) / step + 1e-9) + 1;
  const rate = codesPerSecond / step;
  const frameAt = (seconds: number) => Math.min(Math.max(Math.floor(seconds * rate + 1e-9), 0), count - 1);
  return { count, codes: { first, step }, timeOf: (frame) => frame / rate, frameAt };
}

function lastBefore(times: readonly number[], seconds: number): number {
  let [low, high] = [0, times.length - 1];
  while (low < high) {
    const middle = Math.ceil((low + high) / 2);
    if ((times[middle] ?? 0) <= seconds) low = middle;
    else high = middle - 1;
  }
  return low;
}
