import type { DepthSensor, Vec3 } from "../protocol";
import { rotate } from "../util/pose";
import type { Shown } from "./studio";

/** How far from the true depth a point may be that the pixel shows, as a share of its distance. */
const SAME = 0.02;

/** Finds where an OAK's sensor sees a point of the world, as fractions of the image; null behind it. */
export function project({ header, state }: Shown, sensor: DepthSensor, point: Vec3): { x: number; y: number; z: number } | null {
  const [x, y, z, w] = state.pose.quaternion;
  const { position } = state.pose;
  const inBody = rotate([-x, -y, -z, w], [point[0] - position[0], point[1] - position[1], point[2] - position[2]]);
  const m = sensor.bodyFromCamera;
  const offset = inBody.map((value, row) => value - (m[row * 4 + 3] ?? 0));
  const along = (column: number) => [0, 1, 2].reduce((sum, row) => sum + (m[row * 4 + column] ?? 0) * (offset[row] ?? 0), 0);
  const depth = along(2);
  if (depth <= 0) return null;
  const fraction = (value: number, degrees: number) => 0.5 + value / (2 * depth * Math.tan((degrees * Math.PI) / 360));
  return { x: fraction(along(0), header.hfovDeg), y: fraction(along(1), header.vfovDeg), z: depth };
}

/** The same for a point that the sensor's camera sees: inside its image, and not hidden. */
export function visiblePixel(frame: Shown, sensor: DepthSensor, point: Vec3): { x: number; y: number } | null {
  const place = project(frame, sensor, point);
  const truth = frame.pictures.get("reference") ?? frame.pictures.get("depth");
  if (!place || !truth || place.x < 0 || place.x >= 1 || place.y < 0 || place.y >= 1) return null;
  const index = Math.floor(place.y * truth.height) * truth.width + Math.floor(place.x * truth.width);
  const metres = (truth.data[index] ?? 0) / 1000;
  return Math.abs(metres - place.z) <= SAME * place.z ? { x: place.x, y: place.y } : null;
}
