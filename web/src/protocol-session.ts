// Trajectories, animated scenes and sessions: a part of `protocol.ts`.
import type { CalibrationInfo, Pose, SceneInfo } from "./protocol";

/** The time codes of an animated scene. */
export interface Animation {
  first: number;
  last: number;
  codesPerSecond: number;
  /** The time codes from frame to frame. */
  step: number;
}

export interface TrajectoryInfo {
  id: string;
  name: string;
  poses: Pose[];
  /** The time of each pose in seconds, from 0. */
  timesS: number[];
}

/** What a session has: the state of the page, which only the page understands, and the ids of what was dropped. */
export interface SaveRequest {
  document: unknown;
  display: unknown;
  scene: string;
  calibrations: string[];
  trajectory: string | null;
}

export interface SessionInfo {
  document: unknown;
  display: unknown;
  scene: SceneInfo;
  calibrations: CalibrationInfo[];
  trajectory: TrajectoryInfo | null;
}
