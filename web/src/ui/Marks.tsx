import type { PanelKind } from "../state/display";
import { findSensor, WHOLE_IMAGE } from "../state/document";
import type { Shown } from "../studio/studio";
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
  // Another OAK sees the same point elsewhere; the point in the 3D view connects them.
  if (hover.oak !== oak || !frame) return null;
  const baseline = findSensor(catalog, frame.state)?.baselineM ?? null;
  const shift = kind === "right" ? disparity(frame, baseline, probe?.oak === oak ? probe.trueM : null) : 0;
  if (shift === null) return null;
  return <div class="cross" style={{ left: `${(hover.x - shift) * 100}%`, top: `${hover.y * 100}%` }} />;
}

/** How much further left the right camera sees a point, as a fraction of the width; null if the distance is not known. */
function disparity({ header }: Shown, baselineM: number | null, trueM: number | null): number | null {
  if (!baselineM || !trueM) return null;
  return baselineM / (trueM * 2 * Math.tan((header.hfovDeg * Math.PI) / 360));
}
