// One large image with thumbnails, which can be maximized, enlarged and moved, between side bars of any width.
import assert from "node:assert/strict";
import { after as afterAll, before, test } from "node:test";
import { after, dropScene, launch, open, pixels, rest, skip } from "./page.mjs";

let browser;
before(async () => {
  if (!skip) browser = await launch();
});
afterAll(() => browser?.close());

const width = async (page, id) => (await page.locator(`[data-testid="${id}"] .surface`).boundingBox()).width;

test("one image is large, a thumbnail takes its place, and a double click maximizes", { skip }, async () => {
  const { page, context, errors } = await open(browser, { viewport: { width: 1440, height: 900 } });
  assert.ok((await width(page, "panel-oak1-sensor")) > 2 * (await width(page, "panel-oak1-error")));
  await page.locator('[data-testid="panel-oak1-error"] .surface').click();
  await rest(page);
  assert.ok((await width(page, "panel-oak1-error")) > 2 * (await width(page, "panel-oak1-sensor")));
  const before = await width(page, "panel-oak1-error");
  await page.locator('[data-testid="panel-oak1-error"] .surface').dblclick();
  await page.getByTestId("restore").waitFor();
  await rest(page);
  assert.ok((await width(page, "panel-oak1-error")) > 1.3 * before);
  assert.equal(await page.locator(".panel").count(), 1);
  await page.keyboard.press("Escape");
  await page.getByTestId("restore").waitFor({ state: "detached" });
  assert.equal(await width(page, "panel-oak1-error"), before);
  await page.getByTestId("grid").click();
  await rest(page);
  assert.equal(await width(page, "panel-oak1-error"), await width(page, "panel-oak1-sensor"), "a grid has one size");
  assert.deepEqual(errors, []);
  await context.close();
});

test("the wheel enlarges the place under the mouse, and Shift and dragging moves it", { skip }, async () => {
  const { page, context, errors } = await open(browser);
  const whole = await pixels(page, "sensor");
  const box = await page.locator('[data-testid="panel-oak1-sensor"] .surface').boundingBox();
  const at = [box.x + box.width * 0.75, box.y + box.height * 0.25];
  const probed = async () => {
    await page.mouse.move(at[0], at[1]);
    await page.mouse.move(at[0] + 0.2, at[1]);
    await rest(page);
    await page.locator('[data-testid="readout"] dl').waitFor();
    return (await page.locator('[data-testid="readout"] dd').first().textContent()).split(",").map(Number);
  };
  const before = await probed();
  await page.mouse.wheel(0, -1000);
  await page.getByTestId("zoom").waitFor();
  await rest(page);
  assert.notEqual(await pixels(page, "sensor"), whole);
  const enlarged = await probed();
  for (const axis of [0, 1]) assert.ok(Math.abs(enlarged[axis] - before[axis]) <= 2, `${before} and ${enlarged}`);
  await page.keyboard.down("Shift");
  await page.mouse.down();
  await page.mouse.move(at[0] - box.width / 4, at[1], { steps: 3 });
  await page.mouse.up();
  await page.keyboard.up("Shift");
  const moved = await probed();
  assert.ok(moved[0] > before[0] + 20, `${before} and ${moved}`);
  assert.equal(await page.locator(".region").count(), 0, "moving draws no rectangle");
  await page.getByTestId("zoom").click();
  await rest(page);
  assert.equal(await pixels(page, "sensor"), whole);
  assert.deepEqual(errors, []);
  await context.close();
});

test("the side bars can be resized by mouse and by keyboard", { skip }, async () => {
  const { page, context, errors } = await open(browser, { viewport: { width: 1440, height: 900 } });
  const side = async (name) => (await page.locator(`.side.${name}`).boundingBox()).width;
  const [left, right] = [await side("left"), await side("right")];
  const edge = await page.getByTestId("edge-left").boundingBox();
  await page.mouse.move(edge.x + 3, 500);
  await page.mouse.down();
  await page.mouse.move(edge.x + 83, 500, { steps: 4 });
  await page.mouse.up();
  assert.ok(Math.abs((await side("left")) - left - 80) < 2);
  await page.getByTestId("edge-right").focus();
  await page.keyboard.press("ArrowLeft");
  assert.ok((await side("right")) > right + 10);
  await page.getByTestId("edge-left").dblclick({ position: { x: 3, y: 300 } });
  assert.equal(await side("left"), left);
  assert.deepEqual(errors, []);
  await context.close();
});

test("four OAKs, their names and their numbers fit", { skip }, async () => {
  const { page, context, errors } = await open(browser, { viewport: { width: 1440, height: 900 } });
  for (const label of ["OAK-D Lite", "OAK-D Pro", "OAK-D ToF"]) await after(page, () => page.getByTestId("add-oak").selectOption({ label }));
  for (const [size, least] of [[[1440, 900], 180], [[1024, 768], 120]]) {
    await page.setViewportSize({ width: size[0], height: size[1] });
    await page.waitForTimeout(300);
    await rest(page);
    const hidden = await page.evaluate(() => [...document.querySelectorAll(".panels, .scroll-x, [data-testid='thumbnails'] .panel-title, .oak .detail")].filter((element) => {
      return element.scrollWidth > element.clientWidth + 1 || (element.matches(".panels") && element.scrollHeight > element.clientHeight + 1);
    }).map((element) => `${element.className}: ${element.textContent}`));
    assert.deepEqual(hidden, [], size.join(" × "));
    for (const key of ["oak1", "oak2", "oak3", "oak4"]) assert.ok((await width(page, `panel-${key}-sensor`)) >= least);
  }
  const names = await page.locator('[data-testid="statistics"] thead th').allInnerTexts();
  assert.ok(names.every((name) => name.includes("OAK")), names.join());
  assert.deepEqual(errors, []);
  await context.close();
});

test("images and the chart follow the window and the system's colours", { skip }, async () => {
  const { page, context, errors } = await open(browser, { viewport: { width: 1440, height: 900 }, colorScheme: "light" });
  const chart = page.locator('[data-testid="accuracy"] canvas');
  await chart.waitFor();
  const looks = async () => [await pixels(page, "sensor"), await chart.evaluate((canvas) => canvas.toDataURL())];
  const light = await looks();
  const changed = (before) => page.waitForFunction((before) => document.querySelector('[data-testid="accuracy"] canvas')?.toDataURL() !== before, before);
  await page.emulateMedia({ colorScheme: "dark" });
  await changed(light[1]);
  await rest(page);
  const dark = await looks();
  assert.notEqual(dark[0], light[0]);
  await page.emulateMedia({ colorScheme: "light" });
  await changed(dark[1]);
  await rest(page);
  assert.deepEqual(await looks(), light);
  await page.setViewportSize({ width: 3840, height: 2160 });
  await page.waitForFunction(() => {
    const holder = document.querySelector('[data-testid="accuracy"] .plot');
    return holder.clientWidth > 300 && Math.abs(holder.querySelector(".uplot").clientWidth - holder.clientWidth) <= 1;
  });
  assert.deepEqual(errors, []);
  await context.close();
});

/** A plate 2 m in front of the origin, with a hole of two pixels in front of another plate. */
const HOLED = ["v 2 -3 -3", "v 2 3 -3", "v 2 3 3", "v 2 -3 3", "v 2 -0.004 -0.004", "v 2 0.004 -0.004", "v 2 0.004 0.004", "v 2 -0.004 0.004",
  "f 1 2 6", "f 1 6 5", "f 2 3 7", "f 2 7 6", "f 3 4 8", "f 3 8 7", "f 4 1 5", "f 4 5 8"].join("\n");

test("a hole of a few pixels stays visible in a thumbnail", { skip }, async () => {
  const { page, context } = await open(browser, { viewport: { width: 1440, height: 900 } });
  await dropScene(page, "holed.obj", HOLED);
  await after(page, () => page.evaluate(() => window.studio.document.commit("test", (before) => ({
    ...before, oaks: before.oaks.map((oak) => ({ ...oak, state: { ...oak.state, pose: { position: [0, -0.0375, 0.0011], quaternion: [0, 0, 0, 1] } } })),
  }))));
  await rest(page);
  const contrast = await page.evaluate(() => {
    const shown = document.querySelector('[data-testid="panel-oak1-depth"] canvas');
    const canvas = new OffscreenCanvas(shown.width, shown.height);
    canvas.getContext("2d").drawImage(shown, 0, 0);
    const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
    const green = Array.from({ length: data.length / 4 }, (_, i) => data[i * 4 + 1]);
    const usual = green.toSorted((a, b) => a - b)[green.length >> 1];
    return Math.max(...green.map((value) => Math.abs(value - usual)));
  });
  assert.ok(contrast > 24, `the hole differs by ${contrast} of 255`);
  await context.close();
});
