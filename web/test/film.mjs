// Records the animation of the page: a flight, two OAKs and their difference, pixels without a value, and a painted surface.
import { rest } from "./page.mjs";
import { animation } from "./webp.mjs";

const WIDTH = 800;
const QUALITY = 0.38;
/** How long a frame of a movement is shown, and the last one of a scene, ms. */
const STEP = 200;
const PAUSE = 1400;

/** The object whose surface is painted. */
const PAINTED = "/Room/Shell/Floor";

/** Takes frames of the page and joins them. */
export class Film {
  #frames = [];
  #height = 0;

  constructor(page) {
    this.page = page;
  }

  async take(milliseconds = STEP) {
    await rest(this.page);
    await this.add(await this.page.screenshot({ type: "png" }), milliseconds);
  }

  /** Adds a picture, of which only the rectangle is kept that differs from the one before. */
  async add(picture, milliseconds) {
    const { text, height, place } = await this.page.evaluate(async ([text, width, quality]) => {
      const bytes = Uint8Array.from(atob(text), (character) => character.charCodeAt(0));
      const bitmap = await createImageBitmap(new Blob([bytes]));
      const canvas = new OffscreenCanvas(width, Math.round((bitmap.height * width) / bitmap.width));
      const context = canvas.getContext("2d", { alpha: false });
      context.imageSmoothingQuality = "high";
      context.drawImage(bitmap, 0, 0, canvas.width, canvas.height);
      const { data } = context.getImageData(0, 0, canvas.width, canvas.height);
      const before = window.lastOfFilm;
      window.lastOfFilm = data;
      // Blocks of 8 x 8 pixels whose mean difference can be seen.
      const [low, high] = [[canvas.width, canvas.height], [0, 0]];
      for (let y = 0; y < canvas.height; y += 8) {
        for (let x = 0; x < canvas.width; x += 8) {
          const [right, bottom] = [Math.min(x + 8, canvas.width), Math.min(y + 8, canvas.height)];
          let sum = 0;
          for (let row = y; before && row < bottom; row++) {
            for (let i = (row * canvas.width + x) * 4; i < (row * canvas.width + right) * 4; i++) sum += Math.abs(data[i] - before[i]);
          }
          if (before && sum <= 3 * 4 * 64) continue;
          [low[0], low[1], high[0], high[1]] = [Math.min(low[0], x), Math.min(low[1], y), Math.max(high[0], right), Math.max(high[1], bottom)];
        }
      }
      // A frame has at least one block.
      const place = high[0] > 0 ? [...low, high[0] - low[0], high[1] - low[1]] : [0, 0, 8, 8];
      const part = new OffscreenCanvas(place[2], place[3]);
      part.getContext("2d", { alpha: false }).drawImage(canvas, -place[0], -place[1]);
      const blob = await part.convertToBlob({ type: "image/webp", quality });
      let binary = "";
      for (const byte of new Uint8Array(await blob.arrayBuffer())) binary += String.fromCharCode(byte);
      return { text: btoa(binary), height: canvas.height, place };
    }, [picture.toString("base64"), WIDTH, QUALITY]);
    this.#height = height;
    this.#frames.push({ file: Buffer.from(text, "base64"), milliseconds, place });
  }

  /** The animated WebP file. */
  file() {
    return animation(this.#frames, WIDTH, this.#height);
  }
}

/** Records everything, on a page that shows the demo room. */
export async function record(page) {
  const film = new Film(page);
  // The pictures are small.
  await page.getByTestId("full-size").selectOption("small");
  await film.take(PAUSE);
  // The OAK moves ahead and turns.
  await page.getByTestId("view").focus();
  for (let i = 0; i < 4; i++) {
    await page.keyboard.press("ArrowUp");
    await page.keyboard.press("ArrowUp");
    await page.keyboard.press("ArrowUp");
    await page.keyboard.press("Alt+ArrowLeft");
    await film.take();
  }
  for (let i = 0; i < 4; i++) {
    await page.keyboard.press("ArrowDown");
    await page.keyboard.press("ArrowDown");
    await page.keyboard.press("ArrowDown");
    await page.keyboard.press("Alt+ArrowRight");
    await film.take();
  }
  // A second OAK, and by how much its errors are larger.
  await page.getByTestId("add-oak").selectOption({ label: "OAK-D Lite" });
  await film.take(PAUSE);
  await page.locator('[data-testid$="-error"] .surface').first().click();
  await film.take(PAUSE);
  await page.getByTestId("comparison").selectOption("difference");
  await film.take(PAUSE);
  await page.getByTestId("comparison").selectOption("none");
  await page.getByTestId("oaks").getByRole("button", { name: "Remove" }).last().click();
  // Why pixels have no value.
  await page.getByTestId("show-reason").click();
  await rest(page);
  const panel = await page.locator('[data-testid$="-reason"] canvas').boundingBox();
  for (let i = 0; i <= 4; i++) {
    await page.mouse.move(panel.x + panel.width * (0.75 - 0.42 * (i / 4)), panel.y + panel.height * (0.4 + 0.26 * (i / 4)));
    await page.waitForTimeout(300);
    await film.take(2 * STEP);
  }
  await film.take(PAUSE);
  // What is measured of a surface.
  await page.getByTestId("tab-place").click();
  await page.getByTestId("target").selectOption(PAINTED);
  await page.locator('[data-testid="coverage"] table').waitFor();
  await film.take(PAUSE);
  await page.getByTestId("view").focus();
  for (let i = 0; i < 5; i++) {
    for (let step = 0; step < 3; step++) await page.keyboard.press("PageUp");
    await page.keyboard.press("Alt+ArrowDown");
    await film.take(1.5 * STEP);
  }
  await film.take(PAUSE);
  return film;
}
