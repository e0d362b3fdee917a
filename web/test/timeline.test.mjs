// Trajectories, animated scenes, and sessions that have them.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { after as afterAll, before, test } from "node:test";
import { read } from "./image.mjs";
import { after, drop, launch, open, pixels, rest, skip } from "./page.mjs";

let browser;
before(async () => {
  if (!skip) browser = await launch();
});
afterAll(() => browser?.close());

const shown = (page) => page.evaluate(() => window.studio.document.get());
const ended = (page) => page.waitForFunction(() => document.querySelector('[data-testid="play"]').getAttribute("aria-label").startsWith("Play"));

/** Poses of the first OAK, `step` metres apart along x. */
async function path(page, count, step) {
  const { position: [x, y, z], quaternion } = (await shown(page)).oaks[0].state.pose;
  return Array.from({ length: count }, (_, k) => [k / 10, (x + k * step).toFixed(6), y, z, ...quaternion].join(" ")).join("\n");
}

/** A plate before the OAK that moves away from it in a second. */
const STAGE = `#usda 1.0
(
    metersPerUnit = 1
    upAxis = "Z"
    startTimeCode = 0
    endTimeCode = 20
    timeCodesPerSecond = 20
)
def Mesh "Plate"
{
    int[] faceVertexCounts = [4]
    int[] faceVertexIndices = [0, 1, 2, 3]
    point3f[] points = [(2, -2, -2), (2, 2, -2), (2, 2, 2), (2, -2, 2)]
    double3 xformOp:translate.timeSamples = { 0: (0, 0, 0), 20: (1, 0, 0) }
    uniform token[] xformOpOrder = ["xformOp:translate"]
}
`;

const PATH_COLOR = 0x7c3aed;

/** The number of pixels of the 3D view with a colour. */
async function drawnOf(page, color) {
  const { data } = await read(page, await page.getByTestId("view").screenshot());
  let count = 0;
  for (let at = 0; at < data.length; at += 4) count += ((data[at] << 16) | (data[at + 1] << 8) | data[at + 2]) === color;
  return count;
}

test("an OAK moves along a trajectory, whose frames differ in their noise", { skip }, async () => {
  const { page, context, errors } = await open(browser);
  await after(page, async () => drop(page, "path.txt", await path(page, 8, 0)));
  await page.getByTestId("timeline").waitFor();
  const [first, depth] = [await pixels(page, "sensor"), await pixels(page, "depth")];
  await page.getByTestId("frame").focus();
  await after(page, () => page.keyboard.press("ArrowRight"));
  assert.equal((await shown(page)).oaks[0].state.frame, 1);
  assert.notEqual(await pixels(page, "sensor"), first, "the next frame has other noise");
  assert.equal(await pixels(page, "depth"), depth, "and shows the same");
  await after(page, () => page.keyboard.press("ArrowLeft"));
  assert.equal(await pixels(page, "sensor"), first, "a frame is always the same");

  assert.equal(await drawnOf(page, PATH_COLOR), 0, "a standing OAK has no way");
  await after(page, async () => drop(page, "way.txt", await path(page, 12, 0.05)));
  await rest(page);
  assert.ok((await drawnOf(page, PATH_COLOR)) > 10, "the 3D view shows the way");
  const start = (await shown(page)).oaks[0].state.pose.position[0];
  await page.evaluate(() => {
    window.seen = [];
    window.studio.document.subscribe(() => window.seen.push(window.studio.document.get().moment?.frame));
  });
  await after(page, () => page.getByTestId("play").click());
  await ended(page);
  await rest(page);
  const { moment, oaks } = await shown(page);
  assert.deepEqual(moment, { frame: 11, time: null });
  assert.equal(oaks[0].state.frame, 11);
  assert.ok(Math.abs(oaks[0].state.pose.position[0] - start - 0.55) < 1e-6);
  const seen = await page.evaluate(() => window.seen);
  assert.ok(seen.length > 2 && seen.every((frame, i) => i === 0 || frame >= seen[i - 1]), String(seen));
  await after(page, () => page.getByTestId("view").press("ArrowLeft"));
  assert.equal((await shown(page)).oaks[0].state.frame, 0, "an OAK that leaves the trajectory takes frames on its own");
  assert.deepEqual(errors, []);
  await context.close();
});

test("an animated scene moves in the images and in the 3D view", { skip }, async () => {
  const { page, context, errors } = await open(browser);
  await after(page, () => drop(page, "plate.usda", STAGE));
  await page.getByTestId("timeline").waitFor();
  await rest(page);
  const median = async () => {
    await rest(page);
    return page.evaluate(async () => {
      const { scene, moment, oaks } = window.studio.document.get();
      const at = moment === null || moment.time === null ? scene : `${scene}@${moment.time}`;
      const request = { what: "image", format: "npy", image: "depth", scene: at, state: oaks[0].state, size: [64, 40] };
      const bytes = await (await fetch("/api/export", { method: "POST", body: JSON.stringify(request) })).arrayBuffer();
      const values = [...new Float32Array(bytes.slice(bytes.byteLength - 64 * 40 * 4))].filter(Number.isFinite).sort((a, b) => a - b);
      return values[Math.floor(values.length / 2)];
    });
  };
  const [opened, exact] = [await median(), await pixels(page, "depth")];
  await after(page, () => page.getByTestId("frame").fill("10"));
  const half = await median();
  assert.notEqual(await pixels(page, "depth"), exact);
  assert.deepEqual((await shown(page)).moment, { frame: 10, time: 10 });
  assert.equal((await shown(page)).oaks[0].state.frame, 0, "a frame at rest is one on its own");
  assert.match(await page.getByTestId("moment").textContent(), /0\.5 s, frame 10 of 20, time code 10/);
  assert.notEqual(half, opened);
  const drawn = await page.evaluate(() => window.studio.drawn);
  await page.getByTestId("speed").selectOption("0.5");
  await after(page, () => page.keyboard.press("Home"));
  await page.getByTestId("view").focus();
  await after(page, () => page.keyboard.press("Space"));
  await ended(page);
  await rest(page);
  assert.ok(await page.evaluate(() => window.studio.drawn) > drawn + 1, "the 3D view follows");
  assert.deepEqual((await shown(page)).moment, { frame: 20, time: 20 });
  await after(page, () => page.getByTestId("leave-timeline").click());
  assert.equal(await pixels(page, "depth"), exact, "the scene as it was opened");
  assert.deepEqual(errors, []);
  await context.close();
});

test("a session has everything in one file, and a damaged one changes nothing", { skip }, async () => {
  const { page, context, errors } = await open(browser);
  await after(page, () => drop(page, "plate.usda", STAGE));
  await rest(page);
  await after(page, async () => drop(page, "path.txt", await path(page, 5, 0.1)));
  await after(page, () => page.getByTestId("frame").fill("3"));
  await after(page, () => page.getByTestId("show-reason").click());
  const [state, sensor] = [await shown(page), await pixels(page, "sensor")];
  await page.getByTestId("export").click();
  const [download] = await Promise.all([page.waitForEvent("download"), page.getByRole("menuitem", { name: "Session" }).click()]);
  assert.equal(download.suggestedFilename(), "plate.oaktwin");
  const file = await readFile(await download.path());
  assert.deepEqual(errors, []);
  await context.close();

  const other = await open(browser);
  const before = await shown(other.page);
  const put = (name, buffer) => other.page.getByTestId("file").setInputFiles({ name, mimeType: "application/zip", buffer });
  for (const [name, buffer] of [["half.oaktwin", file.subarray(0, file.length / 2)], ["text.oaktwin", Buffer.from("solid part")]]) {
    await put(name, buffer);
    await other.page.getByTestId("notice").filter({ hasText: `${name}: is not a session` }).waitFor();
  }
  assert.deepEqual(await shown(other.page), before);
  await after(other.page, () => put("plate.oaktwin", file));
  await other.page.getByTestId("timeline").waitFor();
  await rest(other.page);
  assert.deepEqual(await shown(other.page), state);
  assert.equal(await pixels(other.page, "sensor"), sensor);
  await other.page.getByTestId("panel-oak1-reason").waitFor();
  await other.context.close();
});
