import type { DepthSensor, Vec3 } from "../protocol";
import type { PanelKind } from "../state/display";
import { findSensor, WHOLE_IMAGE } from "../state/document";
import type { Shown } from "../studio/studio";
import { rotate } from "../util/pose";
import { useSelected, useStore } from "../util/store";
import { useApp } from "./context";

/** The marks over an image: the probed pixel and the rectangle of the statistics. */
export function Marks({ oak, kind }: { oak: string; kind: PanelKind }) {
  const { studio } = useApp();
  const region = useSelected(studio.document, (document) => document.region);
  const isWhole = region.every((edge, i) => edge === WHOLE_IMAGE[i]);
  const [left, top, right, bottom] = region;
  return (
    <>
      {!isWhole && (
        <div
          class="region"
          style={{ left: `${left * 100}%`, top: `${top * 100}%`, width: `${(right - left) * 100}%`, height: `${(bottom - top) * 100}%` }}
        />
      )}
      <Cross oak={oak} kind={kind} />
    </>
  );
}

function Cross({ oak, kind }: { oak: string; kind: PanelKind }) {
  const { studio } = useApp();
  const hover = useStore(studio.hover);
  const probe = useStore(studio.probe);
  const catalog = useStore(studio.catalog);
  if (!hover) return null;
  const frame = studio.frames.get().get(oak);
  const sensor = frame && findSensor(catalog, frame.state);
  if (!frame || !sensor) return null;
  const seen = probe?.point ? project(frame, sensor, probe.point) : null;
  // The pixel under the mouse is known before the server answers; other OAKs see the same point elsewhere.
  const place = hover.oak === oak ? { x: hover.x, y: hover.y, z: seen?.z ?? null } : seen;
  if (!place || place.x < 0 || place.x > 1 || place.y < 0 || place.y > 1) return null;
  const shift = kind === "right" ? disparity(frame, sensor.baselineM, place.z) : 0;
  if (shift === null) return null;
  const isOther = hover.oak !== oak;
  return <div class={`cross ${isOther ? "other" : ""}`} style={{ left: `${(place.x - shift) * 100}%`, top: `${place.y * 100}%` }} />;
}

/** Finds where an OAK's sensor sees a point of the world, as fractions of the image; null behind it. */
function project({ header, state }: Shown, sensor: DepthSensor, point: Vec3): { x: number; y: number; z: number } | null {
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

/** How much further left the right camera sees a point, as a fraction of the width; null if the distance is not known. */
function disparity({ header }: Shown, baselineM: number | null, depthM: number | null): number | null {
  if (!baselineM || !depthM) return null;
  return baselineM / (depthM * 2 * Math.tan((header.hfovDeg * Math.PI) / 360));
}
