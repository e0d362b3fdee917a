import { type Rgb, TABLE_SIZE } from "../gpu/colormaps";

/** The space around panels, CSS pixels. */
const MARGIN = 10;

/**
 * Draws all image panels of the page with their captions into one PNG, at the resolution of their pixels; null if there are none.
 */
export async function composePanels(page: Document): Promise<Blob | null> {
  const panels = [...page.querySelectorAll<HTMLElement>(".panel")];
  const first = panels[0]?.querySelector("canvas");
  const grid = panels[0]?.parentElement;
  if (!first || !grid || first.clientWidth === 0) return null;
  const scale = Math.max(1, first.width / first.clientWidth);
  const boxes = panels.map((panel) => panel.getBoundingClientRect());
  const left = Math.min(...boxes.map((box) => box.left)) - MARGIN;
  const top = Math.min(...boxes.map((box) => box.top)) - MARGIN;
  const right = Math.max(...boxes.map((box) => box.right)) + MARGIN;
  const bottom = Math.max(...boxes.map((box) => box.bottom)) + MARGIN;
  const canvas = new OffscreenCanvas(Math.round((right - left) * scale), Math.round((bottom - top) * scale));
  const context = canvas.getContext("2d");
  if (!context) return null;
  const style = getComputedStyle(page.documentElement);
  context.scale(scale, scale);
  context.translate(-left, -top);
  context.fillStyle = style.getPropertyValue("--page");
  context.fillRect(left, top, right - left, bottom - top);
  for (const panel of panels) drawPanel(context, panel, style);
  return canvas.convertToBlob({ type: "image/png" });
}

function drawPanel(context: OffscreenCanvasRenderingContext2D, panel: HTMLElement, style: CSSStyleDeclaration): void {
  const caption = panel.querySelector("figcaption")?.getBoundingClientRect();
  if (caption) {
    const text = ["panel-title", "panel-oak", "panel-fact"].map((name) => panel.querySelector(`.${name}`)?.textContent).filter(Boolean);
    context.fillStyle = style.getPropertyValue("--text");
    context.font = `${style.fontSize} system-ui, sans-serif`;
    context.textBaseline = "middle";
    context.fillText(text.join("  "), caption.left, caption.top + caption.height / 2, caption.width);
  }
  for (const image of panel.querySelectorAll("canvas")) {
    const { x, y, width, height } = image.getBoundingClientRect();
    context.save();
    const wiped = image.closest<HTMLElement>(".wiped");
    const hidden = wiped ? (Number.parseFloat(/([\d.]+)%/.exec(wiped.style.clipPath)?.[1] ?? "0") / 100) * width : 0;
    context.beginPath();
    context.rect(x + hidden, y, width - hidden, height);
    context.clip();
    context.imageSmoothingEnabled = false;
    context.drawImage(image, x, y, width, height);
    context.restore();
  }
}

/** What is written below a picture. */
export interface Caption {
  title: string;
  /** A line about what was measured and how. */
  detail: string;
  /** A colour scale with the texts at its ends, RGBA; null without one. */
  scale: { table: Uint8Array; from: string; to: string } | null;
  /** Colours with their meanings. */
  colors: { color: Rgb; name: string }[];
}

/** The least width of a picture with a caption, pixels. */
const LEAST_WIDTH = 480;

/** Puts a picture over its caption, in the resolution of the picture, black on white. */
export function captioned(picture: ImageBitmap | OffscreenCanvas | HTMLCanvasElement, caption: Caption): Promise<Blob> {
  const width = Math.max(LEAST_WIDTH, picture.width);
  const unit = Math.max(13, Math.round(width / 64));
  const line = Math.round(unit * 1.7);
  const measure = new OffscreenCanvas(1, 1).getContext("2d");
  if (!measure) throw new Error("The browser has no canvas.");
  measure.font = `${unit}px system-ui, sans-serif`;
  // The entries of the legend, in as many rows as they need.
  const entries = caption.colors.map((entry) => ({ ...entry, width: measure.measureText(entry.name).width + 2.2 * unit }));
  let [x, rows] = [unit, entries.length ? 1 : 0];
  const places = entries.map((entry) => {
    if (x > unit && x + entry.width > width - unit) [x, rows] = [unit, rows + 1];
    const place = { ...entry, x, row: rows - 1 };
    x += entry.width;
    return place;
  });
  const height = picture.height + line * (2 + Number(caption.scale !== null) + rows) + unit;
  const canvas = new OffscreenCanvas(width, height);
  const context = canvas.getContext("2d") as OffscreenCanvasRenderingContext2D;
  context.fillStyle = "#ffffff";
  context.fillRect(0, 0, width, height);
  context.drawImage(picture, Math.round((width - picture.width) / 2), 0);
  context.fillStyle = "#000000";
  context.textBaseline = "middle";
  let y = picture.height + unit / 2 + line / 2;
  context.font = `600 ${unit}px system-ui, sans-serif`;
  context.fillText(caption.title, unit, y, width - 2 * unit);
  context.font = measure.font;
  y += line;
  context.fillText(caption.detail, unit, y, width - 2 * unit);
  if (caption.scale) {
    y += line;
    const { table, from, to } = caption.scale;
    const gradient = new OffscreenCanvas(TABLE_SIZE, 1);
    gradient.getContext("2d")?.putImageData(new ImageData(new Uint8ClampedArray(table), TABLE_SIZE, 1), 0, 0);
    const left = 2 * unit + context.measureText(from).width;
    const length = width / 3;
    context.fillText(from, unit, y);
    context.drawImage(gradient, left, y - unit / 2, length, unit);
    context.fillText(to, left + length + unit, y);
  }
  for (const { color, name, x, row } of places) {
    const middle = y + line * (row + 1);
    context.fillStyle = `rgb(${color.join()})`;
    context.fillRect(x, middle - unit / 2, unit, unit);
    context.strokeStyle = "#808080";
    context.strokeRect(x, middle - unit / 2, unit, unit);
    context.fillStyle = "#000000";
    context.fillText(name, x + 1.4 * unit, middle);
  }
  return canvas.convertToBlob({ type: "image/png" });
}
