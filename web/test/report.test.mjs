// The report of all OAKs by day and by night.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { after as afterAll, before, test } from "node:test";
import { after, launch, open, skip } from "./page.mjs";

let browser;
before(async () => {
  if (!skip) browser = await launch();
});
afterAll(() => browser?.close());

test("a report has the coverage of every OAK by day and by night, with pictures", { skip }, async () => {
  const { page, context, errors } = await open(browser);
  await after(page, () => page.locator('[data-testid="model"]').first().selectOption("OAK-D Lite"));
  await after(page, () => page.getByTestId("add-oak").selectOption({ label: "OAK-D ToF" }));
  await page.getByTestId("tab-place").click();
  await page.getByTestId("target").selectOption("/Room/Table/Top");
  await page.getByLabel("Count only errors up to").check();
  await page.getByLabel("Tolerance").fill("40");
  const made = async (id) => {
    const [download] = await Promise.all([page.waitForEvent("download"), page.getByTestId(id).click()]);
    return readFile(await download.path(), "utf8");
  };
  const [head, ...lines] = (await made("report-csv")).trimEnd().split("\n").map((line) => line.split(","));
  const rows = lines.map((line) => Object.fromEntries(head.map((name, i) => [name, line[i]])));
  assert.deepEqual(rows.map(({ model, engine, light }) => [model, engine, light]), [
    ["OAK-D Lite", "stereo-matching", "day"], ["OAK-D Lite", "stereo-matching", "night"],
    ["OAK-D ToF", "time-of-flight", "day"], ["OAK-D ToF", "time-of-flight", "night"],
  ]);
  const measured = rows.map((row) => Number(row.measured));
  assert.ok(measured[0] > 0.1 && measured[1] < measured[0] / 2, `a pair without a projector sees little by night: ${measured}`);
  assert.equal(measured[2], measured[3], "the light does not matter to its own light");
  const own = await page.evaluate(async () => {
    const { scene, oaks, target } = window.studio.document.get();
    const states = [{ ...oaks[0].state, engine: "stereo-matching", parameters: {} }];
    const body = JSON.stringify({ scene, states, region: target, toleranceMm: 40 });
    return (await (await fetch("/api/coverage", { method: "POST", body })).json()).poses[0].measured;
  });
  assert.equal(measured[0], own, "the numbers are those of the page");
  const html = await made("report-html");
  assert.equal((html.match(/<img [^>]*src="data:image\/png;base64,/g) ?? []).length, 12);
  assert.match(html, /an error of at most 40 mm/);
  const plain = await context.newPage();
  await plain.setContent(html);
  assert.equal(await plain.locator("tbody tr").count(), 4);
  assert.ok(await plain.evaluate(() => [...document.images].every(({ complete, naturalWidth }) => complete && naturalWidth >= 480)));
  assert.deepEqual(errors, []);
  await context.close();
});
