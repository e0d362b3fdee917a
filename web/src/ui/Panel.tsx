import { useEffect, useLayoutEffect, useRef, useState } from "preact/hooks";
import { css, oakColor } from "../gpu/colormaps";
import type { Scales } from "../gpu/scales";
import { type PanelKind, PANELS } from "../state/display";
import type { Oak, Rectangle } from "../state/document";
import type { Shown } from "../studio/studio";
import { share, signedMillimetres } from "../util/format";
import { useSelected, useStore } from "../util/store";
import { useApp } from "./context";
import { Marks } from "./Marks";

interface Props {
  oak: Oak;
  index: number;
  kind: PanelKind;
  /** The image right of the edge of a wipe. */
  other: PanelKind | null;
  /** CSS pixels. */
  width: number;
  scales: Scales;
}

/** A pointer that moved less than this between press and release, in pixels, did not drag. */
const DRAG = 5;

/** One image of one OAK. */
export function Panel({ oak, index, kind, other, width, scales }: Props) {
  const { studio } = useApp();
  const frame = useSelected(studio.frames, (frames) => frames.get(oak.key));
  const rejection = useSelected(studio.rejections, (rejections) => rejections.get(oak.key));
  const wipeAt = useSelected(studio.display, (display) => display.wipeAt);
  const aspect = frame ? aspectOf(frame) : 1.6;
  const title = (kind: PanelKind) => PANELS.find((panel) => panel.kind === kind)?.title ?? kind;
  const height = Math.round(width / aspect);
  return (
    <figure class={`panel ${rejection && frame ? "stale" : ""}`} data-testid={`panel-${oak.key}-${kind}`}>
      <figcaption>
        <span class="dot-small" style={{ background: css(oakColor(index)) }} />
        <span class="panel-title">{other ? `${title(kind)} | ${title(other)}` : title(kind)}</span>
        <span class="panel-oak">{oak.state.model}</span>
        <span class="spring" />
        {frame && <span class={`panel-fact ${frame.isPreview ? "provisional" : ""}`}>{fact(kind, frame)}</span>}
        {frame && <Fineness frame={frame} />}
      </figcaption>
      <Surface oak={oak.key} label={`${title(kind)} of ${oak.state.model}`} width={width} height={height}>
        <Picture oak={oak.key} kind={kind} frame={frame} width={width} height={height} scales={scales} />
        {other && (
          <div class="wiped" style={{ clipPath: `inset(0 0 0 ${wipeAt * 100}%)` }}>
            <Picture oak={oak.key} kind={other} frame={frame} width={width} height={height} scales={scales} />
          </div>
        )}
        {other && <Edge at={wipeAt} width={width} />}
        <Marks oak={oak.key} kind={kind} />
        {rejection && frame && <p class="stale-note">{`Not measured: ${rejection.error}`}</p>}
        {!frame && <p class="empty">{emptyText(rejection?.error, studio.hasDepth(oak.state), oak.state.model)}</p>}
      </Surface>
    </figure>
  );
}

/** The edge of a wipe, which the mouse moves; the slider above the images does it by keyboard. */
function Edge({ at, width }: { at: number; width: number }) {
  const { studio } = useApp();
  const grab = (event: PointerEvent) => {
    event.stopPropagation();
    const start = event.clientX;
    const move = (next: PointerEvent) => studio.show({ wipeAt: Math.max(0, Math.min(1, at + (next.clientX - start) / width)) });
    addEventListener("pointermove", move);
    addEventListener("pointerup", () => removeEventListener("pointermove", move), { once: true });
  };
  return <div class="edge" style={{ left: `${at * 100}%` }} onPointerDown={grab} />;
}

/** Whether an image is a preview, and its size. */
function Fineness({ frame }: { frame: Shown }) {
  const picture = frame.pictures.get("sensor");
  if (!picture) return null;
  const size = `${picture.width} × ${picture.height}`;
  return frame.isPreview
    ? <span class="fineness preview" data-testid="fineness" data-tip="Coarse while something changes; the final image follows">{`preview ${size}`}</span>
    : <span class="fineness" data-testid="fineness">{size}</span>;
}

function emptyText(error: string | undefined, hasDepth: boolean, model: string): string {
  if (error) return error;
  return hasDepth ? "Measuring…" : `${model} has no depth sensor.`;
}

function aspectOf(frame: Shown): number {
  const picture = frame.pictures.get("sensor") ?? [...frame.pictures.values()][0];
  return picture ? picture.width / picture.height : 1.6;
}

/** The number that says most about an image. */
function fact(kind: PanelKind, { header: { statistics } }: Shown): string {
  if (kind === "sensor" || kind === "reason") return `${share(statistics.fillRate)} filled`;
  if (kind === "error") return `median ${signedMillimetres(statistics.medianErrorM)}`;
  return "";
}

function Picture({ oak, kind, frame, width, height, scales }: {
  oak: string; kind: PanelKind; frame: Shown | undefined; width: number; height: number; scales: Scales;
}) {
  const { painter, repaint, studio, signals } = useApp();
  const display = useStore(studio.display);
  const again = useStore(repaint);
  const canvas = useRef<HTMLCanvasElement>(null);
  const [isMissing, setMissing] = useState(false);
  const source = frame?.pictures.get(kind === "error" ? "sensor" : kind);
  // More pixels than the image has would show nothing more.
  const ratio = Math.min(devicePixelRatio * width, source?.width ?? 640) / width;
  const { depthMap, errorUnit } = display;
  const truth = kind === "error" || kind === "depth" ? (frame?.pictures.get("reference") ?? frame?.pictures.get("depth")) : undefined;
  const range = kind === "error" ? [scales.error] : kind === "depth" || kind === "sensor" ? scales.depth : [];
  useLayoutEffect(() => {
    const target = canvas.current;
    if (!target || !frame) return;
    const [pixelWidth, pixelHeight] = [Math.max(1, Math.round(width * ratio)), Math.max(1, Math.round(height * ratio))];
    if (target.width !== pixelWidth) target.width = pixelWidth;
    if (target.height !== pixelHeight) target.height = pixelHeight;
    setMissing(!painter.paint(target, { oak, kind, frame, display, scales, empty: emptyColors() }));
    signals.painted++;
  }, [source, truth, width, height, ratio, range[0], range[1], depthMap, errorUnit, kind, again, display.theme, frame === undefined]);
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

/** The area of an image that the mouse probes and drags a rectangle on, and where arrow keys move the probed pixel. */
function Surface({ oak, label, width, height, children }: {
  oak: string; label: string; width: number; height: number; children: preact.ComponentChildren;
}) {
  const { studio } = useApp();
  const element = useRef<HTMLDivElement>(null);
  const stopDrag = useRef<() => void>(() => {});
  useEffect(() => () => stopDrag.current(), []);
  const at = (event: PointerEvent): [number, number] => {
    const box = element.current?.getBoundingClientRect() ?? new DOMRect(0, 0, 1, 1);
    const inside = (value: number) => Math.max(0, Math.min(0.99999, value));
    return [inside((event.clientX - box.left) / box.width), inside((event.clientY - box.top) / box.height)];
  };
  const hover = (event: PointerEvent) => {
    const [x, y] = at(event);
    studio.hover.set({ oak, x, y });
  };
  const press = (event: PointerEvent) => {
    if (event.button !== 0) return;
    const [x, y] = at(event);
    const [startX, startY] = [event.clientX, event.clientY];
    const move = (next: PointerEvent) => {
      if (Math.hypot(next.clientX - startX, next.clientY - startY) < DRAG) return;
      const [toX, toY] = at(next);
      const region: Rectangle = [Math.min(x, toX), Math.min(y, toY), Math.max(x, toX), Math.max(y, toY)];
      studio.document.commit("region", (document) => ({ ...document, region }));
    };
    const end = () => {
      removeEventListener("pointermove", move);
      removeEventListener("pointerup", end);
    };
    stopDrag.current = end;
    addEventListener("pointermove", move);
    addEventListener("pointerup", end);
  };
  const key = (event: KeyboardEvent) => {
    const [right, down] = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key] ?? [0, 0];
    if (right === 0 && down === 0) return;
    event.preventDefault();
    event.stopPropagation();
    const step = event.shiftKey ? 0.002 : 0.02;
    const { x, y } = studio.hover.get() ?? { x: 0.5, y: 0.5 };
    const inside = (value: number) => Math.max(0, Math.min(0.99999, value));
    studio.hover.set({ oak, x: inside(x + (right ?? 0) * step), y: inside(y + (down ?? 0) * step) });
  };
  return (
    <div
      ref={element}
      class="surface"
      role="application"
      aria-label={`${label}. Arrow keys move the probed pixel.`}
      tabIndex={0}
      style={{ width: `${width}px`, height: `${height}px` }}
      onPointerMove={hover}
      onPointerDown={press}
      onKeyDown={key}
    >
      {children}
    </div>
  );
}
