import { depthTable, errorTable, reasonColor } from "../gpu/colormaps";
import { findScales, type Scales } from "../gpu/scales";
import type { PanelKind } from "../state/display";
import type { Shown } from "../studio/studio";
import { decimal, millimetres, share, signedMillimetres, words } from "../util/format";
import { type Caption, captioned } from "./compose";
import type { App } from "./context";
import { titleOf } from "./Panel";

/** The colours of pixels without a value on paper. */
const EMPTY = [0.84, 0.86, 0.89, 0.74, 0.77, 0.81];

/** Returns an image of an OAK as a PNG in its own resolution, with the scale of the page and a caption; null if it is not there. */
export async function captionedImage(app: App, oak: string, kind: PanelKind): Promise<Blob | null> {
  const frames = app.studio.frames.get();
  const frame = frames.get(oak);
  return frame ? captionedFrame(app, oak, frame, kind, findScales(frames.values(), app.studio.display.get())) : null;
}

/** The same for a frame that the page need not show. */
export async function captionedFrame({ studio, painter }: App, oak: string, frame: Shown, kind: PanelKind, scales: Scales): Promise<Blob | null> {
  const source = frame.pictures.get(kind === "error" ? "sensor" : kind);
  if (!source) return null;
  const display = studio.display.get();
  const target = document.createElement("canvas");
  [target.width, target.height] = [source.width, source.height];
  if (!painter.paint(target, { oak, kind, frame, display, scales, empty: EMPTY })) return null;
  const picture = await createImageBitmap(target);
  return captioned(picture, {
    title: `${titleOf(kind)}: ${frame.state.model}, ${words(frame.state.engine)}, ${studio.scene.get()?.name ?? ""}`,
    detail: detail(frame, source, kind === "sensor" || kind === "error" || kind === "reason" || kind === "confidence"),
    ...colors(studio, frame, kind, scales, display),
  });
}

/** What is known about an image; errors belong to what is measured only. */
function detail({ header: { statistics }, state }: Shown, { width, height }: { width: number; height: number }, isMeasured: boolean): string {
  const at = state.pose.position.map((metres) => decimal(metres, 3)).join(", ");
  const measured = [
    `${share(statistics.fillRate)} filled`, `median error ${signedMillimetres(statistics.medianErrorM)}`,
    `median |error| ${millimetres(statistics.medianAbsoluteErrorM)}`,
  ];
  return [`${width} × ${height}`, `at ${at} m`, ...(isMeasured ? measured : [])].join(", ");
}

function colors(
  { catalog }: App["studio"], frame: Shown, kind: PanelKind, scales: Scales, display: Parameters<typeof findScales>[1],
): Pick<Caption, "scale" | "colors"> {
  const none = { color: [214, 219, 227] as [number, number, number], name: "No value" };
  if (kind === "depth" || kind === "sensor") {
    const [from, to] = scales.depth.map((metres) => `${decimal(metres, 3)} m`) as [string, string];
    return { scale: { table: depthTable(display.depthMap), from, to }, colors: kind === "sensor" ? [none] : [] };
  }
  if (kind === "error") {
    const end = display.errorUnit === "mm" ? `${decimal(scales.error * 1000, 2)} mm` : `${decimal(scales.error, 2)} %`;
    return { scale: { table: errorTable(), from: `−${end} (too near)`, to: `+${end} (too far)` }, colors: [none] };
  }
  if (kind === "reason") {
    const { reasons } = frame.header.statistics;
    const present = catalog.get().reasons.filter(({ code }) => (reasons[code] ?? 0) > 0);
    return { scale: null, colors: present.map(({ code, name }) => ({ color: reasonColor(code), name: words(name) })) };
  }
  if (kind === "confidence") return { scale: { table: depthTable(display.depthMap), from: "0", to: "255" }, colors: [] };
  return { scale: null, colors: [] };
}
