// What the page says must be true while it moves, and belong to what it shows.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { after as afterAll, before, test } from "node:test";
import { after, dropScene, launch, open, rest, skip } from "./page.mjs";

let browser;
before(async () => {
  if (!skip) browser = await launch();
});
afterAll(() => browser?.close());

/** A plate with two triangles, 2 m in front of the origin. */
const PLATE = "v 2 -1 -1\nv 2 1 -1\nv 2 1 1\nv 2 -1 1\nf 1 2 3\nf 1 3 4\n";

/** Remembers what the page says about the images of an OAK at each change. */
async function record(page) {
  await page.evaluate(() => {
    window.said = [];
    const look = () => {
      const badge = document.querySelector('[data-testid="panel-oak1-sensor"] [data-testid="fineness"]')?.textContent;
      const fact = document.querySelector('[data-testid="panel-oak1-sensor"] .panel-fact');
      const cell = document.querySelector('[data-testid="statistics"] tbody td');
      const bar = document.querySelector('[data-testid="reasons"] .stack');
      if (!badge || !fact || !cell || !bar) return;
      const next = { badge, fill: Number.parseFloat(fact.textContent), isGrey: fact.classList.contains("provisional"), isCellGrey: [cell, bar].every((one) => one.classList.contains("provisional")) };
      if (JSON.stringify(window.said.at(-1)) !== JSON.stringify(next)) window.said.push(next);
    };
    new MutationObserver(look).observe(document.body, { subtree: true, childList: true, characterData: true, attributes: true });
    look();
  });
}

test("previews are marked, and say nearly what the final images say", { skip }, async () => {
  const { page, context, errors } = await open(browser);
  await record(page);
  for (let step = 0; step < 6; step++) {
    await page.evaluate(() => {
      const { document } = window.studio;
      document.commit("test", (before) => ({
        ...before,
        oaks: before.oaks.map((oak) => ({ ...oak, state: { ...oak.state, pose: { ...oak.state.pose, position: oak.state.pose.position.map((x, i) => x + (i === 1 ? 0.01 : 0)) } } })),
      }));
    });
    await page.waitForTimeout(120);
  }
  await rest(page);
  const said = await page.evaluate(() => window.said);
  const previews = said.filter(({ badge }) => badge.startsWith("preview"));
  const finals = said.filter(({ badge }) => !badge.startsWith("preview"));
  assert.ok(previews.length > 0 && finals.length > 0, JSON.stringify(said));
  assert.ok(previews.every(({ isGrey, isCellGrey }) => isGrey && isCellGrey), "numbers of a preview are grey");
  const last = said.at(-1);
  assert.ok(!last.badge.startsWith("preview") && !last.isGrey && !last.isCellGrey, JSON.stringify(last));
  for (const { badge, fill } of previews) assert.ok(Math.abs(fill - last.fill) < 5, `${badge}: ${fill} % and ${last.fill} % at rest`);
  assert.deepEqual(errors, []);
  await context.close();
});

test("the parameters that people change first come first", { skip }, async () => {
  const { page, context, errors } = await open(browser);
  const names = async () => {
    const first = page.getByTestId("parameter-group").first();
    assert.equal(await first.getByRole("heading").first().textContent(), "Changed first");
    return first.locator("[data-parameter]").evaluateAll((fields) => fields.map((field) => field.dataset.parameter));
  };
  assert.deepEqual(await names(), ["confidenceThreshold", "subpixel", "leftRightCheckThreshold", "jitter", "bias"]);
  await after(page, () => page.getByTestId("engine").selectOption("single-view"));
  assert.deepEqual((await names()).slice(0, 2), ["noiseSigma", "noiseMean"]);
  assert.deepEqual(errors, []);
  await context.close();
});

test("the time of flight sensor of an OAK-D ToF comes first", { skip }, async () => {
  const { page, context, errors } = await open(browser);
  await after(page, () => page.getByTestId("add-oak").selectOption({ label: "OAK-D ToF" }));
  const sensors = await page.evaluate(() => window.studio.document.get().oaks.map(({ state }) => [state.sensor, state.engine]));
  assert.deepEqual(sensors.at(-1), ["depth_tof", "time-of-flight"]);
  assert.deepEqual(errors, []);
  await context.close();
});

test("the confidence of stereo-noise is shown", { skip }, async () => {
  const { page, context, errors } = await open(browser);
  await after(page, () => page.getByTestId("show-confidence").click());
  await rest(page);
  const text = await page.getByTestId("panel-oak1-confidence").textContent();
  assert.doesNotMatch(text, /makes no confidence/);
  assert.deepEqual(errors, []);
  await context.close();
});

test("exported statistics name the OAKs, their poses, the rectangle and the reasons", { skip }, async () => {
  const { page, context, errors } = await open(browser);
  await after(page, () => page.getByTestId("duplicate").click());
  const surface = page.locator('[data-testid="panel-oak1-sensor"] .surface');
  const box = await surface.boundingBox();
  await after(page, async () => {
    await page.mouse.move(box.x + box.width * 0.25, box.y + box.height * 0.25);
    await page.mouse.down();
    await page.mouse.move(box.x + box.width * 0.75, box.y + box.height * 0.75, { steps: 4 });
    await page.mouse.up();
  });
  const save = async (name) => {
    await page.getByTestId("export").click();
    const [download] = await Promise.all([page.waitForEvent("download"), page.getByRole("menuitem", { name, exact: true }).click()]);
    return readFile(await download.path(), "utf8");
  };
  const report = JSON.parse(await save("Statistics (JSON)"));
  const [left, top, right, bottom] = report.rectangle;
  assert.ok(left > 0.2 && top > 0.2 && right < 0.8 && bottom < 0.8, JSON.stringify(report.rectangle));
  assert.equal(report.oaks.length, 2);
  for (const oak of report.oaks) {
    assert.ok(oak.model && oak.engine === "stereo-noise" && oak.pose.position.length === 3);
    assert.ok(Object.keys(oak.lost).every((name) => /^[a-z_]+$/.test(name)), JSON.stringify(oak.lost));
  }
  const shown = await page.locator('[data-testid="statistics"] tbody tr').first().locator("td").first().textContent();
  assert.ok(Math.abs(report.oaks[0].fillRate * 100 - Number.parseFloat(shown)) < 0.06, `${report.oaks[0].fillRate} and ${shown}`);
  const rows = (await save("Statistics (CSV)")).trimEnd().split("\n").map((row) => row.split(","));
  assert.equal(rows.length, 3);
  assert.ok(rows.every((row) => row.length === rows[0].length));
  assert.equal(rows[1][rows[0].indexOf("model")], report.oaks[0].model);
  assert.deepEqual(errors, []);
  await context.close();
});

test("a pose of a sweep moves the OAK that it was found for, and a ranking belongs to its region", { skip }, async () => {
  const { page, context, errors } = await open(browser);
  await after(page, () => page.getByTestId("duplicate").click());
  await page.evaluate(() => window.studio.document.commit("test", (before) => ({ ...before, arePosesLinked: false, selected: "oak1" })));
  await page.getByTestId("tab-place").click();
  await page.getByTestId("target").selectOption("/Room/Table/Top");
  for (const field of await page.getByTestId("sweep").getByLabel("steps").all()) await field.fill("1");
  await page.getByTestId("sweep").getByLabel("Height").fill("1.7");
  await page.getByTestId("run-sweep").click();
  await page.locator("table.ranking").waitFor();
  await page.setViewportSize({ width: 1024, height: 768 });
  const scrolled = await page.locator("table.ranking").evaluate(({ parentElement: { scrollWidth, clientWidth } }) => scrollWidth - clientWidth);
  assert.ok(scrolled <= 1, `${scrolled} pixels of the ranking are not visible`);
  await page.evaluate(() => window.studio.document.commit("select", (before) => ({ ...before, selected: "oak2" })));
  await after(page, () => page.locator("table.ranking").getByRole("button", { name: "Take" }).first().click());
  const heights = await page.evaluate(() => Object.fromEntries(window.studio.document.get().oaks.map(({ key, state }) => [key, state.pose.position[2]])));
  assert.ok(Math.abs(heights.oak1 - 1.7) < 1e-6 && Math.abs(heights.oak2 - 1.7) > 0.1, JSON.stringify(heights));
  // Numbers of another region are grey until its own are there.
  const coverage = page.locator('[data-testid="coverage"] table');
  await page.locator('[data-testid="coverage"] table:not(.provisional)').waitFor();
  let answer;
  const held = new Promise((resolve) => { answer = resolve; });
  await page.route("**/api/coverage", (route) => held.then(() => route.continue()));
  await page.getByTestId("target").selectOption("/Room/Table");
  await page.locator("table.ranking").waitFor({ state: "detached" });
  assert.match(await coverage.getAttribute("class"), /provisional/);
  answer();
  await page.locator('[data-testid="coverage"] table:not(.provisional)').waitFor();
  assert.deepEqual(errors, []);
  await context.close();
});

test("coverage has a tolerance, and shares of what can be seen and of all OAKs together", { skip }, async () => {
  const { page, context, errors } = await open(browser);
  await after(page, () => page.getByTestId("duplicate").click());
  await page.getByTestId("tab-place").click();
  await page.getByTestId("target").selectOption("/Room/Table/Top");
  const row = async (name) => {
    const cells = await page.locator('[data-testid="coverage"] tbody tr').filter({ hasText: name }).locator("td").allTextContents();
    return cells.map((cell) => Number.parseFloat(cell));
  };
  await page.locator('[data-testid="coverage"] table').waitFor();
  const [visible, measured, ofVisible] = [await row("Visible, %"), await row("Measured, %"), await row("Measured of visible, %")];
  assert.equal(measured.length, 3, "two OAKs, and all together");
  assert.ok(Math.abs(ofVisible[0] - (100 * measured[0]) / visible[0]) < 0.5, `${ofVisible[0]}`);
  await page.getByLabel("Count only errors up to").check();
  await page.getByLabel("Tolerance").fill("0.1");
  await page.waitForFunction(() => document.querySelector('[data-testid="coverage"]').textContent.toLowerCase().includes("inaccurate"));
  assert.ok((await row("Measured, %"))[0] < measured[0]);
  assert.deepEqual(errors, []);
  await context.close();
});

test("a scene that is dropped again has the same link", { skip }, async () => {
  const { page, context } = await open(browser);
  const id = async () => {
    await dropScene(page, "plate.obj", PLATE);
    return page.evaluate(() => window.studio.document.get().scene);
  };
  const first = await id();
  assert.match(first, /^dropped-[0-9a-f]{24}$/);
  await page.reload();
  await page.waitForFunction(() => window.studio?.isIdle);
  assert.equal(await id(), first);
  await context.close();
});
