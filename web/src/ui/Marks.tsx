import type { PanelKind } from "../state/display";
import { findSensor, WHOLE_IMAGE } from "../state/document";
import { project } from "../studio/project";
import type { Shown } from "../studio/studio";
import { useSelected, useStore } from "../util/store";
import { NO_ZOOM } from "../util/zoom";
import { useApp } from "./context";

/** The marks over an image: the probed pixel, the rectangle of the statistics and, of a thumbnail, the part that is zoomed into. */
export function Marks({ oak, kind, isZoomed }: { oak: string; kind: PanelKind; isZoomed: boolean }) {
  const { studio } = useApp();
  const zoom = useStore(studio.zoom);
  const { scale, x, y } = isZoomed ? zoom : NO_ZOOM;
  const region = useSelected(studio.document, (document) => document.region);
  const isWhole = region.every((edge, i) => edge === WHOLE_IMAGE[i]);
  const [left, top, right, bottom] = region;
  return (
    <div class="marks" style={{ left: `${-x * scale * 100}%`, top: `${-y * scale * 100}%`, width: `${scale * 100}%`, height: `${scale * 100}%` }}>
      {!isZoomed && zoom.scale > 1 && (
        <div class="zoomed" style={{ left: `${zoom.x * 100}%`, top: `${zoom.y * 100}%`, width: `${100 / zoom.scale}%`, height: `${100 / zoom.scale}%` }} />
      )}
      {!isWhole && (
        <div
          class="region"
          style={{ left: `${left * 100}%`, top: `${top * 100}%`, width: `${(right - left) * 100}%`, height: `${(bottom - top) * 100}%` }}
        />
      )}
      <Cross oak={oak} kind={kind} />
    </div>
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

/** How much further left the right camera sees a point, as a fraction of the width; null if the distance is not known. */
function disparity({ header }: Shown, baselineM: number | null, depthM: number | null): number | null {
  if (!baselineM || !depthM) return null;
  return baselineM / (depthM * 2 * Math.tan((header.hfovDeg * Math.PI) / 360));
}
