// Two OAKs in one panel, what all OAKs share, the first steps, and pictures for a report.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { after as afterAll, before, test } from "node:test";
import { read } from "./image.mjs";
import { after, launch, open, rest, skip } from "./page.mjs";

let browser;
before(async () => {
  if (!skip) browser = await launch();
});
afterAll(() => browser?.close());

/** Returns the pixels of the canvases of the panel that compares, RGBA. */
async function compared(page) {
  await rest(page);
  return page.evaluate(() => [...document.querySelectorAll('[data-testid="panel-comparison"] canvas')].map((shown) => {
    const canvas = new OffscreenCanvas(shown.width, shown.height);
    canvas.getContext("2d").drawImage(shown, 0, 0);
    return { width: shown.width, height: shown.height, data: [...canvas.getContext("2d").getImageData(0, 0, shown.width, shown.height).data] };
  }));
}

const setState = (page, key, change) => page.evaluate(([key, change]) => window.studio.document.commit("test", (before) => ({
  ...before,
  arePosesLinked: false,
  oaks: before.oaks.map((oak) => (oak.key === key ? { ...oak, state: { ...oak.state, ...change } } : oak)),
})), [key, change]);

test("the difference of two OAKs is 0 for equal ones and favours the better one", { skip }, async () => {
  const { page, context, errors } = await open(browser);
  await after(page, () => page.getByTestId("duplicate").click());
  await page.getByTestId("comparison").selectOption("difference");
  /** The share of pixels that are bluer than red, and the reverse. */
  const shares = async () => {
    const [{ data }] = await compared(page);
    let [blue, red] = [0, 0];
    for (let i = 0; i < data.length; i += 4) {
      if (data[i + 2] > data[i] + 40) blue++;
      if (data[i] > data[i + 2] + 40) red++;
    }
    return { blue: (4 * blue) / data.length, red: (4 * red) / data.length };
  };
  const equal = await shares();
  assert.ok(equal.blue < 0.001 && equal.red < 0.001, JSON.stringify(equal));
  await after(page, () => setState(page, "oak2", { parameters: { bias: "2" } }));
  const second = await shares();
  assert.ok(second.red > 0.3 && second.blue < 0.1, `the first is better: ${JSON.stringify(second)}`);
  await page.getByTestId("compared-left").selectOption("oak2");
  await page.getByTestId("compared-right").selectOption("oak1");
  const swapped = await shares();
  assert.ok(swapped.blue > 0.3 && swapped.red < 0.1, `the second is better: ${JSON.stringify(swapped)}`);
  assert.deepEqual(errors, []);
  await context.close();
});

test("two OAKs share a panel with an edge, or in turns", { skip }, async () => {
  const { page, context, errors } = await open(browser);
  await after(page, () => page.getByTestId("duplicate").click());
  await after(page, () => setState(page, "oak2", { parameters: { bias: "2" } }));
  await page.getByTestId("comparison").selectOption("wipe");
  const [left, right] = await compared(page);
  assert.notDeepEqual(left.data, right.data);
  const clip = () => page.locator(".wiped").evaluate((element) => element.style.clipPath);
  assert.match(await clip(), /50%/);
  await page.getByLabel("Edge of the wipe").fill("0.25");
  assert.match(await clip(), /25%/);
  await page.getByTestId("comparison").selectOption("blink");
  await page.waitForFunction(() => document.querySelectorAll('[data-testid="panel-comparison"] canvas').length === 1);
  const label = () => page.locator('[data-testid="panel-comparison"] .dot-small').evaluate((element) => element.style.background);
  const first = await label();
  await page.waitForFunction((first) => document.querySelector('[data-testid="panel-comparison"] .dot-small').style.background !== first, first);
  await page.waitForFunction((first) => document.querySelector('[data-testid="panel-comparison"] .dot-small').style.background === first, first);
  await page.getByTestId("comparison").selectOption("none");
  await page.getByTestId("panel-oak2-sensor").waitFor();
  assert.deepEqual(errors, []);
  await context.close();
});

test("engine, light and preset are set for all OAKs that can have them", { skip }, async () => {
  const { page, context, errors } = await open(browser);
  await after(page, () => page.getByTestId("add-oak").selectOption({ label: "OAK-D Pro" }));
  await after(page, () => page.getByTestId("add-oak").selectOption({ label: "OAK-D ToF" }));
  await page.evaluate(() => window.studio.document.commit("select", (before) => ({ ...before, selected: "oak1" })));
  await after(page, () => setState(page, "oak1", { engine: "stereo-matching", ambient: 0.5 }));
  const all = (field) => page.evaluate((field) => window.studio.document.get().oaks.map(({ state }) => state[field]), field);
  await page.getByTestId("for-all").click();
  await after(page, () => page.getByRole("menuitem", { name: "Engine for all" }).click());
  assert.deepEqual(await all("engine"), ["stereo-matching", "stereo-matching", "time-of-flight"]);
  await page.getByTestId("notice").filter({ hasText: "OAK-D ToF" }).waitFor();
  await page.getByTestId("for-all").click();
  await after(page, () => page.getByRole("menuitem", { name: "Light for all" }).click());
  assert.deepEqual((await all("ambient")).slice(0, 2), [0.5, 0.5]);
  await after(page, () => page.keyboard.press("Control+z"));
  assert.deepEqual((await all("ambient")).slice(0, 2), [0.5, 1], "it is one step of undo");
  assert.deepEqual(errors, []);
  await context.close();
});

test("each of three questions leads to a result in two clicks", { skip }, async () => {
  const { page, context, errors } = await open(browser, { viewport: { width: 1440, height: 900 } });
  const start = page.getByTestId("start");
  await start.getByRole("button", { name: "Compare cameras" }).click();
  await after(page, () => start.getByRole("button", { name: "Stereo and time of flight" }).click());
  assert.equal(await page.locator('[data-testid="statistics"] thead th').count(), 2);
  await start.getByRole("button", { name: "Why are there holes?" }).click();
  await after(page, () => start.getByRole("button", { name: "At night" }).click());
  await page.waitForFunction(() => document.querySelectorAll('[data-testid="reasons"] tbody tr').length > 0);
  const isLarge = (await page.locator('[data-testid="panel-oak1-reason"] .surface').boundingBox()).width;
  assert.ok(isLarge > 250);
  const light = await page.evaluate(() => window.studio.document.get().oaks.map(({ state }) => state.ambient));
  assert.deepEqual(light, [0, 0], "it is night for all OAKs");
  await start.getByRole("button", { name: "Where do I mount it?" }).click();
  await start.getByRole("button", { name: "Choose from a list" }).click();
  await page.waitForFunction(() => document.activeElement.dataset.testid === "target");
  await start.getByRole("button", { name: "Do not show this again" }).click();
  await page.reload();
  await rest(page);
  assert.equal(await start.count(), 0);
  assert.deepEqual(errors, []);
  await context.close();
});

test("an image is saved in full resolution with its scale and a caption", { skip }, async () => {
  const { page, context, errors } = await open(browser, { viewport: { width: 1024, height: 700 }, fullSize: "large" });
  for (const name of ["Error with its scale (PNG)", "Sensor depth with its scale (PNG)"]) {
    await page.getByTestId("export").click();
    const [download] = await Promise.all([page.waitForEvent("download"), page.getByRole("menuitem", { name, exact: true }).click()]);
    assert.match(download.suggestedFilename(), /^oaktwin-oak4-d-(error|sensor)\.png$/);
    const { width, height, data } = await read(page, await readFile(await download.path()));
    assert.equal(width, 1280, "the resolution of the image, not of the screen");
    assert.ok(height > 840 && height < 1000, `${height}`);
    const rows = Array.from({ length: height - 800 }, (_, y) => data.subarray((800 + y) * width * 4, (801 + y) * width * 4));
    const has = (test) => rows.some((row) => Array.from({ length: width }, (_, x) => row.subarray(x * 4, x * 4 + 3)).some(test));
    assert.ok(has(([red, green, blue]) => red < 40 && green < 40 && blue < 40), "text");
    assert.ok(has(([red, green, blue]) => Math.max(red, green, blue) - Math.min(red, green, blue) > 100), "a colour scale");
  }
  assert.deepEqual(errors, []);
  await context.close();
});
