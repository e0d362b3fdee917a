import type { Pose, Vec3 } from "../protocol";

/** x, y, z, w. */
export type Quaternion = Pose["quaternion"];

export type UpAxis = "y" | "z";

/** The attitude of a body in degrees: turned about the vertical axis, tilted down, rolled to the right. */
export interface Angles {
  yaw: number;
  pitch: number;
  roll: number;
}

const DEGREE = Math.PI / 180;

/** Rotates a world whose z axis is up to one whose y axis is up. */
const Y_UP: Quaternion = [-Math.SQRT1_2, 0, 0, Math.SQRT1_2];

export function multiply([ax, ay, az, aw]: Quaternion, [bx, by, bz, bw]: Quaternion): Quaternion {
  return [
    aw * bx + ax * bw + ay * bz - az * by,
    aw * by - ax * bz + ay * bw + az * bx,
    aw * bz + ax * by - ay * bx + az * bw,
    aw * bw - ax * bx - ay * by - az * bz,
  ];
}

function conjugate([x, y, z, w]: Quaternion): Quaternion {
  return [-x, -y, -z, w];
}

export function rotate(q: Quaternion, [x, y, z]: Vec3): Vec3 {
  const [rx, ry, rz] = multiply(multiply(q, [x, y, z, 0]), conjugate(q));
  return [rx, ry, rz];
}

export function normalise(q: Quaternion): Quaternion {
  const norm = Math.hypot(...q) || 1;
  return [q[0] / norm, q[1] / norm, q[2] / norm, q[3] / norm];
}

function about(axis: 0 | 1 | 2, degrees: number): Quaternion {
  const half = (degrees * DEGREE) / 2;
  const q: Quaternion = [0, 0, 0, Math.cos(half)];
  q[axis] = Math.sin(half);
  return q;
}

/** Returns the unit vector that points up. */
export function upVector(up: UpAxis): Vec3 {
  return up === "z" ? [0, 0, 1] : [0, 1, 0];
}

export function fromAngles({ yaw, pitch, roll }: Angles, up: UpAxis): Quaternion {
  const level = multiply(multiply(about(2, yaw), about(1, pitch)), about(0, roll));
  return normalise(up === "z" ? level : multiply(Y_UP, level));
}

export function toAngles(quaternion: Quaternion, up: UpAxis): Angles {
  const [x, y, z, w] = normalise(up === "z" ? quaternion : multiply(conjugate(Y_UP), quaternion));
  const sine = Math.max(-1, Math.min(1, 2 * (w * y - z * x)));
  return {
    yaw: Math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z)) / DEGREE,
    pitch: Math.asin(sine) / DEGREE,
    roll: Math.atan2(2 * (w * x + y * z), 1 - 2 * (x * x + y * y)) / DEGREE,
  };
}

/** Moves a pose by metres along its heading, to its left and up, whatever its tilt. */
export function moved(pose: Pose, [forward, left, rise]: Vec3, up: UpAxis): Pose {
  const heading = fromAngles({ yaw: toAngles(pose.quaternion, up).yaw, pitch: 0, roll: 0 }, up);
  const [x, y, z] = rotate(heading, [forward, left, rise]);
  const [px, py, pz] = pose.position;
  return { ...pose, position: [px + x, py + y, pz + z] };
}

/** Turns a pose by degrees. */
export function turned(pose: Pose, change: Partial<Angles>, up: UpAxis): Pose {
  const angles = toAngles(pose.quaternion, up);
  const pitch = Math.max(-90, Math.min(90, angles.pitch + (change.pitch ?? 0)));
  const next = { yaw: angles.yaw + (change.yaw ?? 0), pitch, roll: angles.roll + (change.roll ?? 0) };
  return { ...pose, quaternion: fromAngles(next, up) };
}
