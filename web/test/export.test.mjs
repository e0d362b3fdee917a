import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { after as afterAll, before, test } from "node:test";
import { addressAfter, after, dropScene, launch, open, pixels, rest, skip } from "./page.mjs";

let browser;
before(async () => {
  if (!skip) browser = await launch();
});
afterAll(() => browser?.close());

/** Chooses an entry of the menu and returns the saved file. */
async function exported(page, name) {
  await page.getByTestId("export").click();
  const [download] = await Promise.all([page.waitForEvent("download"), page.getByRole("menuitem", { name, exact: true }).click()]);
  return { name: download.suggestedFilename(), bytes: await readFile(await download.path()) };
}

/** Returns the text that an entry of the menu shows. */
async function shown(page, name) {
  await page.getByTestId("export").click();
  await page.getByRole("menuitem", { name }).click();
  const dialog = page.getByRole("dialog");
  await dialog.waitFor();
  const text = await page.getByTestId("snippet").textContent();
  await page.keyboard.press("Escape");
  await dialog.waitFor({ state: "detached" });
  return text;
}

/** Reads the shape and the values of an NPY file of 32-bit numbers. */
function floats(bytes) {
  const length = bytes.readUInt16LE(8);
  const header = bytes.toString("latin1", 10, 10 + length);
  assert.match(header, /'descr': '<f4'/);
  const shape = /\((\d+), (\d+)\)/.exec(header).slice(1).map(Number);
  return { shape, values: new Float32Array(bytes.buffer.slice(bytes.byteOffset + 10 + length, bytes.byteOffset + bytes.length)) };
}

test("descriptions for robots are saved as archives", { skip }, async () => {
  const { page, context, errors } = await open(browser);
  for (const [title, name] of [["URDF (ZIP)", "urdf"], ["SDF (ZIP)", "sdf"], ["MJCF (ZIP)", "mjcf"], ["Webots (ZIP)", "webots"], ["Blender (ZIP)", "blender"]]) {
    const file = await exported(page, title);
    assert.match(file.name, new RegExp(`^[a-z0-9_]+_${name}\\.zip$`));
    assert.equal(file.bytes.toString("latin1", 0, 4), "PK\x03\x04");
    assert.match(file.bytes.toString("latin1"), /meshes\/[a-z0-9_]+\.obj/, `${name} has its meshes`);
  }
  assert.deepEqual(errors, []);
  await context.close();
});

test("every image that is shown can be saved with its exact values", { skip }, async () => {
  const { page, context, errors } = await open(browser);
  const depth = floats((await exported(page, "Exact depth (NumPy)")).bytes);
  const sensor = floats((await exported(page, "Sensor depth (NumPy)")).bytes);
  const error = floats((await exported(page, "Error (NumPy)")).bytes);
  assert.deepEqual([depth.shape, error.shape], [sensor.shape, sensor.shape]);
  const isFine = depth.values.some((value) => Number.isFinite(value) && Math.abs(value * 1000 - Math.round(value * 1000)) > 0.01);
  assert.ok(isFine, "exact depth is not rounded to millimetres");
  let measured = 0;
  for (let i = 0; i < sensor.values.length; i++) {
    const [exact, own, difference] = [depth.values[i], sensor.values[i], error.values[i]];
    if (Number.isNaN(difference)) continue;
    measured++;
    assert.equal(difference, Math.fround(own - exact));
  }
  assert.ok(measured > sensor.values.length / 4);
  assert.deepEqual(errors, []);
  await context.close();
});

test("a unit of the population and a drift change what is measured, and enter commands and the link", { skip }, async () => {
  const { page, context, errors } = await open(browser);
  const nominal = await pixels(page, "sensor");
  await after(page, () => page.getByTestId("device").selectOption("population"));
  const first = await pixels(page, "sensor");
  assert.notEqual(first, nominal);
  await after(page, () => page.getByTestId("population-seed").fill("7"));
  const unit = await pixels(page, "sensor");
  assert.notEqual(unit, first);
  await page.getByTestId("drift").getByRole("button", { name: "Drift" }).click();
  const yaw = page.locator('[data-testid="drift"] [data-parameter="yaw"] input[type="text"]');
  const received = await page.evaluate(() => window.studio.received);
  await yaw.fill("1000");
  assert.equal(await yaw.getAttribute("aria-invalid"), "true");
  assert.equal(await page.evaluate(() => window.studio.received), received, "nothing is sent");
  const address = await addressAfter(page, () => yaw.fill("0.4"));
  const drifted = await pixels(page, "sensor");
  assert.notEqual(drifted, unit);

  const command = await shown(page, "Command line");
  assert.match(command, /oaktwin population .* --units 1 --seed 7 --output units\n/);
  assert.match(command, /--calibration units\/[a-z0-9_]+_000000\.json .*--drift yaw=0\.4/);
  const python = await shown(page, "Python");
  assert.match(python, /device\.population\(1, seed=7\)\[0\]/);
  assert.match(python, /drift="yaw=0\.4"/);
  const other = await open(browser, { path: address });
  assert.equal(await pixels(other.page, "sensor"), drifted, "the link restores both");
  await other.context.close();

  await after(page, () => page.getByTestId("drift").getByRole("button", { name: "Reset", exact: true }).click());
  assert.equal(await pixels(page, "sensor"), unit);
  await after(page, () => page.getByTestId("device").selectOption(""));
  assert.equal(await pixels(page, "sensor"), nominal);
  assert.deepEqual(errors, []);
  await context.close();
});

test("colours are recorded on request, which enters the command and the script", { skip }, async () => {
  const { page, context, errors } = await open(browser);
  const [colour, depth] = [await pixels(page, "color"), await pixels(page, "depth")];
  await page.getByRole("button", { name: "Colours and glass" }).click();
  await addressAfter(page, () => page.getByLabel("Recorded colours").check());
  const recorded = await pixels(page, "color");
  assert.notEqual(recorded, colour);
  assert.match(await shown(page, "Command line"), /--rgb-imager on/);
  assert.match(await shown(page, "Python"), /rgb_imager=True/);
  await addressAfter(page, async () => {
    await page.getByLabel("Light of the scene").fill("0.01");
    await page.keyboard.press("Enter");
  });
  assert.notEqual(await pixels(page, "color"), recorded, "a dim room is noisy");
  assert.equal(await pixels(page, "depth"), depth);
  assert.match(await shown(page, "Command line"), /--rgb-imager light=0.01/);
  await addressAfter(page, () => page.getByLabel("Recorded colours").uncheck());
  assert.equal(await pixels(page, "color"), colour);
  assert.doesNotMatch(await shown(page, "Command line"), /rgb-imager/);
  assert.deepEqual(errors, []);
  await context.close();
});

test("the ground truth of clear surfaces is theirs, or what is behind them", { skip }, async () => {
  const { page, context, errors } = await open(browser);
  await dropScene(page, "pane.gltf", pane());
  await rest(page);
  const surface = floats((await exported(page, "Exact depth (NumPy)")).bytes).values;
  await page.getByRole("button", { name: "Colours and glass" }).click();
  await addressAfter(page, () => page.getByTestId("transparent").selectOption("through"));
  const through = floats((await exported(page, "Exact depth (NumPy)")).bytes).values;
  const farther = surface.filter((value, at) => through[at] > value + 0.01).length;
  const nearer = surface.filter((value, at) => through[at] < value).length;
  assert.ok(farther > surface.length / 50 && nearer === 0, `${farther} and ${nearer} of ${surface.length}`);
  assert.match(await shown(page, "Command line"), /--transparent through/);
  assert.match(await shown(page, "Python"), /transparent="through"/);
  assert.deepEqual(errors, []);
  await context.close();
});

/** A pane of glass of 2 m before a wall of 4 m, 1 m behind it. */
function pane() {
  const corners = (half, z) => [[-half, -half, z], [half, -half, z], [half, half, z], [-half, -half, z], [half, half, z], [-half, half, z]].flat();
  const positions = Buffer.from(new Float32Array([...corners(1, 0), ...corners(2, -1)]).buffer);
  const accessor = (byteOffset, half, z) => ({ bufferView: 0, byteOffset, componentType: 5126, count: 6, type: "VEC3", min: [-half, -half, z], max: [half, half, z] });
  return JSON.stringify({
    asset: { version: "2.0" },
    extensionsUsed: ["KHR_materials_transmission"],
    buffers: [{ byteLength: positions.length, uri: `data:application/octet-stream;base64,${positions.toString("base64")}` }],
    bufferViews: [{ buffer: 0, byteLength: positions.length }],
    accessors: [accessor(0, 1, 0), accessor(72, 2, -1)],
    materials: [{ doubleSided: true, extensions: { KHR_materials_transmission: { transmissionFactor: 1 } }, pbrMetallicRoughness: { metallicFactor: 0, roughnessFactor: 0 } }, { doubleSided: true }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0 }, material: 0 }] }, { primitives: [{ attributes: { POSITION: 1 }, material: 1 }] }],
    nodes: [{ mesh: 0, name: "Pane" }, { mesh: 1, name: "Wall" }],
    scenes: [{ nodes: [0, 1] }],
    scene: 0,
  });
}
