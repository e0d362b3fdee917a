// Dropped files, copied texts and links: what the page asks and says about them.
import assert from "node:assert/strict";
import { after as afterAll, before, test } from "node:test";
import { after, drop, launch, open, rest, skip } from "./page.mjs";

let browser;
before(async () => {
  if (!skip) browser = await launch();
});
afterAll(() => browser?.close());

/** A box of 200 × 100 × 50 units that stands on the plane z = 0, with the corners of a box and two of its sides. */
const PART = ["v -100 -50 0", "v 100 -50 0", "v 100 50 0", "v -100 50 0", "v -100 -50 50", "v 100 -50 50", "f 1 2 3", "f 1 3 4", "f 1 2 6", "f 1 6 5"].join("\n");

test("the units of a part are asked for, with a guess, and enter the link, commands and the size", { skip }, async () => {
  const { page, context, errors } = await open(browser);
  await drop(page, "part.obj", PART);
  await page.getByTestId("use-scene").waitFor();
  assert.equal(await page.getByTestId("unit").inputValue(), "0.001", "200 units are millimetres");
  assert.equal(await page.getByTestId("up").inputValue(), "z", "the z axis begins at the ground");
  assert.match(await page.getByTestId("scene-size").textContent(), /0\.200 m × 0\.100 m × 50\.0 mm/);
  const metres = await page.evaluate(() => window.studio.document.get().scene);
  await after(page, () => page.keyboard.press("Enter"));
  await page.waitForFunction(() => document.querySelector('[data-testid="scene"]').textContent.includes("part.obj"));
  await rest(page);
  const scene = () => page.evaluate(async () => {
    const { scene } = window.studio.document.get();
    return (await fetch(`/api/scenes/${scene}`)).json();
  });
  const first = await scene();
  assert.notEqual(first.id, metres);
  assert.deepEqual([first.scale, first.up], [0.001, "z"]);
  assert.ok(Math.abs(first.bounds[1][0] - 0.1) < 1e-6, JSON.stringify(first.bounds));
  await page.getByTestId("export").click();
  await page.getByRole("menuitem", { name: "Command line" }).click();
  assert.match(await page.getByTestId("snippet").textContent(), /render part\.obj --up z --scale 0\.001 /);
  await page.getByRole("dialog").getByText("in the folder of part.obj").waitFor();
  await page.keyboard.press("Escape");
  await drop(page, "part.obj", PART);
  await page.getByTestId("unit").selectOption("0.0254");
  await after(page, () => page.getByTestId("use-scene").click());
  await rest(page);
  const second = await scene();
  assert.notEqual(second.id, first.id, "other units are another scene");
  assert.equal(second.scale, 0.0254);
  await drop(page, "part.obj", PART);
  await page.getByTestId("use-scene").waitFor();
  await page.keyboard.press("Escape");
  await page.getByRole("dialog").waitFor({ state: "detached" });
  assert.equal((await scene()).id, second.id, "a cancelled file changes nothing");
  assert.deepEqual(errors, []);
  await context.close();
});

test("texts and links are copied without the clipboard of secure pages", { skip }, async () => {
  const { page, context, errors } = await open(browser);
  await page.evaluate(() => {
    Object.defineProperty(navigator, "clipboard", { value: undefined });
    document.addEventListener("copy", () => { window.copied = document.getSelection().toString() || document.activeElement.value; });
  });
  await page.getByTestId("link").click();
  await page.getByTestId("notice").filter({ hasText: "clipboard" }).waitFor();
  assert.match(await page.evaluate(() => window.copied), /#v1\./);
  await page.getByTestId("export").click();
  await page.getByRole("menuitem", { name: "Command line" }).click();
  const text = await page.getByTestId("snippet").textContent();
  assert.match(text, /^oaktwin demo\n/, "the command makes the scene of the demo first");
  await page.getByRole("button", { name: "Copy", exact: true }).click();
  await page.getByRole("button", { name: "Copied" }).waitFor();
  assert.equal((await page.evaluate(() => window.copied)).trim(), text.trim());
  await page.keyboard.press("Escape");
  await page.getByRole("dialog").waitFor({ state: "detached" });
  assert.equal(await page.evaluate(() => document.activeElement.dataset.testid), "export", "the focus returns");
  assert.deepEqual(errors, []);
  await context.close();
});

test("a damaged link says so", { skip }, async () => {
  const { page, context } = await open(browser, { path: "#v1.eyJkb2N1bWVudCI6ey" });
  await page.getByTestId("notice").filter({ hasText: "damaged" }).waitFor();
  await context.close();
});

test("an arrow key opens the list of models instead of adding one", { skip }, async () => {
  const { page, context, errors } = await open(browser);
  await page.getByTestId("add-oak").focus();
  await page.keyboard.press("ArrowDown");
  await page.keyboard.press("Escape");
  assert.equal(await page.evaluate(() => window.studio.document.get().oaks.length), 1);
  assert.deepEqual(errors, []);
  await context.close();
});

test("numbers have minus signs, and fields accept both signs", { skip }, async () => {
  const { page, context, errors } = await open(browser);
  const field = page.getByTestId("position-x");
  const x = () => page.evaluate(() => window.studio.document.get().oaks[0].state.pose.position[0]);
  for (const text of ["-0.25", "−0.5"]) {
    await after(page, () => field.fill(text));
    assert.equal(await x(), Number(text.replace("−", "-")));
  }
  await field.blur();
  assert.equal(await field.inputValue(), "−0.5");
  assert.deepEqual(errors, []);
  await context.close();
});

test("the labels of the chart grow with the density of the screen", { skip }, async () => {
  const { page, context } = await open(browser, { deviceScaleFactor: 2 });
  await page.locator('[data-testid="accuracy"] canvas').waitFor();
  const fonts = await page.evaluate(() => {
    const own = CanvasRenderingContext2D.prototype.fillText;
    const seen = [];
    CanvasRenderingContext2D.prototype.fillText = function (...rest) {
      seen.push(this.font);
      return own.apply(this, rest);
    };
    window.studio.document.commit("test", (before) => ({ ...before, oaks: before.oaks.map((oak) => ({ ...oak, state: { ...oak.state, seed: 1 } })) }));
    return new Promise((resolve) => {
      const look = () => (seen.length ? resolve(seen) : setTimeout(look, 50));
      document.querySelector('[data-testid="theme"]').click();
      look();
    });
  });
  const sizes = fonts.map((font) => Number.parseFloat(font));
  assert.ok(sizes.every((size) => size >= 20), fonts.join("; "));
  await context.close();
});

test("a preview does not wait for images at rest, which follow", { skip }, async () => {
  const { page, context, errors } = await open(browser);
  const answers = await page.evaluate(() => new Promise((resolve, reject) => {
    const { oaks, scene } = window.studio.document.get();
    const socket = new WebSocket(`ws://${location.host}/api/live`);
    socket.binaryType = "arraybuffer";
    const seen = [];
    const request = (id, oak, change) => socket.send(JSON.stringify({
      type: "frame", id, oak, scene, state: { ...oaks[0].state, engine: "stereo-matching" }, images: ["sensor"], region: [0, 0, 1, 1], ...change,
    }));
    socket.onmessage = ({ data }) => {
      if (typeof data === "string") return reject(new Error(data));
      const length = new DataView(data).getUint32(0, true);
      seen.push(JSON.parse(new TextDecoder().decode(new Uint8Array(data, 4, length))).id);
      if (seen.length === 2) resolve(seen);
    };
    socket.onopen = () => {
      request(1, "a", { size: null });
      // The first one is being computed by then.
      setTimeout(() => request(2, "b", { size: [160, 100], isPreview: true }), 40);
    };
  }));
  assert.deepEqual(answers, [2, 1]);
  assert.deepEqual(errors, []);
  await context.close();
});
