import { useEffect, useRef } from "preact/hooks";
import type { Rectangle } from "../state/document";
import { panned, zoomed } from "../util/zoom";
import { useApp } from "./context";

/** A pointer that moved less than this between press and release, in pixels, did not drag. */
const DRAG = 5;
/** The enlargement by one step of a key, and by one unit of a wheel. */
const KEY_ZOOM = 1.5;
const WHEEL_ZOOM = 1.0015;
/** The pixels of a line of a wheel that counts lines. */
const LINE = 16;

interface Props {
  oak: string;
  label: string;
  /** CSS pixels. */
  width: number;
  height: number;
  /** Whether it shows the part of the image that is zoomed into, or all of it. */
  isZoomed: boolean;
  /** What Enter, and a click or a double click, do. */
  onChoose: () => void;
  isChosenByClick: boolean;
  children: preact.ComponentChildren;
}

const inside = (value: number) => Math.max(0, Math.min(0.99999, value));

/**
 * The area of an image that the mouse probes, drags a rectangle on, zooms and moves, and where arrow keys move the probed pixel.
 */
export function Surface({ oak, label, width, height, isZoomed, onChoose, isChosenByClick, children }: Props) {
  const { studio } = useApp();
  const element = useRef<HTMLDivElement>(null);
  const stopDrag = useRef<() => void>(() => {});
  useEffect(() => () => stopDrag.current(), []);
  /** The place of the pointer as fractions of the surface. */
  const place = (event: MouseEvent): [number, number] => {
    const box = element.current?.getBoundingClientRect() ?? new DOMRect(0, 0, 1, 1);
    return [inside((event.clientX - box.left) / box.width), inside((event.clientY - box.top) / box.height)];
  };
  /** The same as fractions of the image. */
  const at = (event: MouseEvent): [number, number] => {
    const [x, y] = place(event);
    const zoom = studio.zoom.get();
    return isZoomed ? [zoom.x + x / zoom.scale, zoom.y + y / zoom.scale] : [x, y];
  };
  const hover = (event: PointerEvent) => {
    const [x, y] = at(event);
    studio.hover.set({ oak, x, y });
  };
  const follow = (move: (event: PointerEvent) => void) => {
    const end = () => {
      removeEventListener("pointermove", move);
      removeEventListener("pointerup", end);
    };
    stopDrag.current = end;
    addEventListener("pointermove", move);
    addEventListener("pointerup", end);
  };
  const press = (event: PointerEvent) => {
    if (isZoomed && (event.button === 1 || (event.button === 0 && event.shiftKey))) {
      event.preventDefault();
      let [lastX, lastY] = [event.clientX, event.clientY];
      follow((next) => {
        studio.zoom.update((zoom) => panned(zoom, (lastX - next.clientX) / width, (lastY - next.clientY) / height));
        [lastX, lastY] = [next.clientX, next.clientY];
      });
      return;
    }
    if (event.button !== 0) return;
    const [x, y] = at(event);
    const [startX, startY] = [event.clientX, event.clientY];
    follow((next) => {
      if (Math.hypot(next.clientX - startX, next.clientY - startY) < DRAG) return;
      const [toX, toY] = at(next);
      const region: Rectangle = [Math.min(x, toX), Math.min(y, toY), Math.max(x, toX), Math.max(y, toY)];
      studio.document.commit("region", (document) => ({ ...document, region }));
    });
  };
  const wheel = (event: WheelEvent) => {
    if (!isZoomed) return;
    event.preventDefault();
    const pixels = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? event.deltaY * LINE : event.deltaY;
    studio.zoom.update((zoom) => zoomed(zoom, WHEEL_ZOOM ** -pixels, place(event)));
  };
  const key = (event: KeyboardEvent) => {
    const factor = isZoomed ? { "+": KEY_ZOOM, "=": KEY_ZOOM, "-": 1 / KEY_ZOOM, "0": 0 }[event.key] : undefined;
    const [right, down] = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key] ?? [0, 0];
    if (event.ctrlKey || event.metaKey || (factor === undefined && event.key !== "Enter" && right === 0 && down === 0)) return;
    event.preventDefault();
    event.stopPropagation();
    if (event.key === "Enter") return onChoose();
    const { x, y } = studio.hover.get() ?? { x: 0.5, y: 0.5 };
    if (factor !== undefined) {
      studio.zoom.update((zoom) => zoomed(zoom, factor, [inside((x - zoom.x) * zoom.scale), inside((y - zoom.y) * zoom.scale)]));
      return;
    }
    const step = event.shiftKey ? 0.002 : 0.02;
    studio.hover.set({ oak, x: inside(x + (right ?? 0) * step), y: inside(y + (down ?? 0) * step) });
  };
  const click = (event: MouseEvent) => {
    // The second of a double click counts as the first: it is what was chosen.
    if (isChosenByClick && event.detail === 1 && !event.shiftKey) onChoose();
  };
  return (
    <div
      ref={element}
      class={`surface ${isChosenByClick ? "thumbnail" : ""}`}
      role="application"
      aria-label={`${label}. Arrow keys move the probed pixel; Enter ${isChosenByClick ? "shows the image large" : "maximizes the image"}.`}
      tabIndex={0}
      style={{ width: `${width}px`, height: `${height}px` }}
      onPointerMove={hover}
      onPointerDown={press}
      onWheel={wheel}
      onClick={click}
      onDblClick={isChosenByClick ? undefined : onChoose}
      onKeyDown={key}
    >
      {children}
    </div>
  );
}
