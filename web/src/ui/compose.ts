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
