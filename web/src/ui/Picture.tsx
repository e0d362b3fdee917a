import { useLayoutEffect, useRef, useState } from "preact/hooks";
import type { Compared } from "../gpu/painter";
import type { Scales } from "../gpu/scales";
import { type PanelKind, PANELS } from "../state/display";
import type { Shown } from "../studio/studio";
import { useStore } from "../util/store";
import { NO_ZOOM } from "../util/zoom";
import { useApp } from "./context";

interface Props {
  oak: string;
  kind: PanelKind;
  frame: Shown | undefined;
  /** CSS pixels. */
  width: number;
  height: number;
  isZoomed: boolean;
  scales: Scales;
  /** The OAK whose errors are compared with this one's, instead of the image. */
  compared?: Compared | undefined;
}

/** The pixels of an image, coloured. */
export function Picture({ oak, kind, frame, width, height, isZoomed, scales, compared }: Props) {
  const { painter, repaint, studio, signals } = useApp();
  const display = useStore(studio.display);
  const again = useStore(repaint);
  const ownZoom = useStore(studio.zoom);
  const { scale, x, y } = isZoomed ? ownZoom : NO_ZOOM;
  const canvas = useRef<HTMLCanvasElement>(null);
  const [isMissing, setMissing] = useState(false);
  const source = frame?.pictures.get(kind === "error" ? "sensor" : kind);
  // An image that is not enlarged has nothing to show in more pixels than its own.
  const ratio = scale > 1 ? devicePixelRatio : Math.min(devicePixelRatio * width, source?.width ?? 640) / width;
  const { depthMap, errorUnit } = display;
  const truth = kind === "error" || kind === "depth" ? (frame?.pictures.get("reference") ?? frame?.pictures.get("depth")) : undefined;
  const range = kind === "error" ? [scales.error] : kind === "depth" || kind === "sensor" ? scales.depth : [];
  useLayoutEffect(() => {
    const target = canvas.current;
    if (!target || !frame) return;
    const [pixelWidth, pixelHeight] = [Math.max(1, Math.round(width * ratio)), Math.max(1, Math.round(height * ratio))];
    if (target.width !== pixelWidth) target.width = pixelWidth;
    if (target.height !== pixelHeight) target.height = pixelHeight;
    const part = [x, y, 1 / scale, 1 / scale] as const;
    setMissing(!painter.paint(target, { oak, kind, frame, display, scales, empty: emptyColors(), part, compared }));
    signals.painted++;
  }, [source, truth, width, height, ratio, scale, x, y, range[0], range[1], depthMap, errorUnit, kind, again, display.theme, frame === undefined, compared?.frame]);
  return (
    <>
      <canvas ref={canvas} class="picture" />
      {isMissing && frame && <p class="empty">{missingText(kind, frame)}</p>}
    </>
  );
}

function missingText(kind: PanelKind, frame: Shown): string {
  const { engine, model } = frame.state;
  const images = PANELS.find((panel) => panel.kind === kind)?.images ?? [];
  if (!images.every((image) => frame.requested.includes(image))) return "Measuring…";
  if (kind === "confidence") return `${engine} makes no confidence.`;
  if (kind === "left" || kind === "right") return `${model} has no stereo pair here.`;
  return "This image is not available.";
}

/** The colours of the hatch of pixels without a value, for the theme. */
function emptyColors(): number[] {
  const style = getComputedStyle(document.documentElement);
  return ["--empty", "--empty-line"].flatMap((name) => {
    const hex = Number.parseInt(style.getPropertyValue(name).trim().slice(1), 16);
    return [(hex >> 16) / 255, ((hex >> 8) & 255) / 255, (hex & 255) / 255];
  });
}
