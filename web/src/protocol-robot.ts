// Robots: a part of `protocol.ts`.
import type { Pose } from "./protocol";

/** A robot, in the posture of its scene. */
export interface RobotInfo {
  name: string;
  /** The joints that can be moved. */
  joints: RobotJoint[];
  /** The links: the path below which the objects of each are, and the pose of its frame in the world. */
  links: { name: string; path: string; pose: Pose }[];
}

export interface RobotJoint {
  name: string;
  /** Whether its positions are angles in radians; otherwise lengths in metres. */
  isRevolute: boolean;
  /** Null for a joint without limits. */
  limits: [number, number] | null;
  position: number;
}
