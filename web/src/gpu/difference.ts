import { Matrix4, Quaternion, Vector3 } from "three";
import type { Catalog, FrameHeader } from "../protocol";
import { findSensor } from "../state/document";
import type { Shown } from "../studio/studio";

/** How the places of two images belong together. */
export interface Correspondence {
  /** From the camera of one image to the camera of the other, column by column. */
  otherFromThis: number[];
  /** The tangents of half the fields of view of both, horizontal and vertical. */
  tangents: [number, number, number, number];
}

/** Finds how two images belong together; null if a sensor is unknown. */
export function correspondence(one: Shown, other: Shown, catalog: Catalog): Correspondence | null {
  const [world, there] = [worldFromCamera(one, catalog), worldFromCamera(other, catalog)];
  if (!world || !there) return null;
  const tangents = ({ hfovDeg, vfovDeg }: FrameHeader) => [hfovDeg, vfovDeg].map((degrees) => Math.tan((degrees * Math.PI) / 360));
  return {
    otherFromThis: there.invert().multiply(world).toArray(),
    tangents: [...tangents(one.header), ...tangents(other.header)] as Correspondence["tangents"],
  };
}

function worldFromCamera({ state }: Shown, catalog: Catalog): Matrix4 | null {
  const sensor = findSensor(catalog, state);
  if (!sensor) return null;
  const { position, quaternion } = state.pose;
  const body = new Matrix4().compose(new Vector3(...position), new Quaternion(...quaternion), new Vector3(1, 1, 1));
  const m = sensor.bodyFromCamera as [number, number, number, number, number, number, number, number, number, number, number, number];
  return body.multiply(new Matrix4().set(...m, 0, 0, 0, 1));
}
