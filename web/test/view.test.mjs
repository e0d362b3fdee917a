// What the 3D view says about the place under the mouse, its ruler and its pictures.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { after as afterAll, before, test } from "node:test";
import { after, dropScene, launch, open, rest, skip } from "./page.mjs";

let browser;
before(async () => {
  if (!skip) browser = await launch();
});
afterAll(() => browser?.close());

/** A plate, 2 m in front of the origin. */
const PLATE = "v 2 -2 -2\nv 2 2 -2\nv 2 2 2\nv 2 -2 2\nf 1 3 2\nf 1 4 3\n";

async function openPlate() {
  const opened = await open(browser, { viewport: { width: 1440, height: 900 }, fullSize: "large" });
  const { page } = opened;
  await dropScene(page, "plate.obj", PLATE);
  await after(page, () => page.evaluate(() => window.studio.document.commit("test", (before) => ({
    ...before, oaks: before.oaks.map((oak) => ({ ...oak, state: { ...oak.state, pose: { position: [0, 0, 0], quaternion: [0, 0, 0, 1] } } })),
  }))));
  await page.getByTestId("view").focus();
  // From where the OAK is: the middle of the view is the point straight ahead.
  await page.keyboard.press("c");
  await rest(page);
  return { ...opened, box: await page.getByTestId("view").boundingBox() };
}

test("the place under the mouse has a point, an object, a distance and a pixel", { skip }, async () => {
  const { page, context, errors, box } = await openPlate();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.getByTestId("pointed").waitFor();
  const text = await page.getByTestId("pointed").textContent();
  const [x, y, z] = /at (.*) m;/.exec(text)[1].replaceAll("−", "-").split(", ").map(Number);
  assert.ok(Math.abs(x - 2) < 1e-3 && Math.abs(y) < 0.01 && Math.abs(z) < 0.01, text);
  assert.ok(Math.abs(Number(/; ([\d.]+) m from the OAK4-D$/.exec(text)[1]) - 2) < 0.002, text);
  await page.locator('[data-testid="readout"] dl').waitFor();
  const facts = await page.locator('[data-testid="readout"] dd').allTextContents();
  const [column, row] = facts[0].split(",").map(Number);
  // The camera of the sensor is beside the middle of the body.
  assert.ok(Math.abs(row - 400) <= 8 && Math.abs(column - 640) < 60, facts[0]);
  assert.ok(Math.abs(Number.parseFloat(facts[1]) - 2) < 0.02, facts[1]);
  await page.mouse.move(box.x + box.width / 2, box.y - 20);
  await page.getByTestId("pointed").waitFor({ state: "detached" });
  assert.deepEqual(errors, []);
  await context.close();
});

test("the ruler measures between two points of the scene", { skip }, async () => {
  const { page, context, errors, box } = await openPlate();
  const at = async (right, down) => {
    await page.mouse.move(box.x + box.width * right, box.y + box.height * down);
    await page.waitForFunction(() => document.querySelector('[data-testid="pointed"]'));
    await page.waitForTimeout(200);
    const text = await page.getByTestId("pointed").textContent();
    return /at (.*) m;/.exec(text)[1].replaceAll("−", "-").split(", ").map(Number);
  };
  // Without the handles of the OAK, which is where the view is.
  await page.keyboard.press("g");
  await page.getByTestId("ruler").click();
  const ends = [];
  for (const [right, down] of [[0.35, 0.35], [0.6, 0.3]]) {
    ends.push(await at(right, down));
    await page.mouse.down();
    await page.mouse.up();
  }
  const distance = Number.parseFloat(await page.locator('[data-testid="distance"] b').textContent());
  const expected = Math.hypot(...ends[0].map((value, axis) => value - ends[1][axis]));
  assert.ok(expected > 0.2 && Math.abs(distance - expected) < 0.01, `${distance} and ${expected}`);
  await page.getByTestId("view").focus();
  await page.keyboard.press("Escape");
  await page.getByTestId("distance").waitFor({ state: "detached" });
  assert.deepEqual(errors, []);
  await context.close();
});

test("a picture of the view is saved", { skip }, async () => {
  const { page, context, errors } = await open(browser);
  const [download] = await Promise.all([page.waitForEvent("download"), page.getByTestId("picture").click()]);
  const bytes = await readFile(await download.path());
  assert.equal(download.suggestedFilename(), "oaktwin-view.png");
  assert.ok(bytes.length > 10_000, "it is not empty");
  assert.deepEqual(errors, []);
  await context.close();
});
