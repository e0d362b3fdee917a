import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { after as afterAll, before, test } from "node:test";
import { after, drop, launch, open, openRobot, pixels, rest, skip } from "./page.mjs";

const LIST = "turn_deg,shoulder_deg,elbow_deg\n0,70,50\n0,40,60\n";

let browser;
before(async () => {
  if (!skip) browser = await launch();
});
afterAll(() => browser?.close());

/** Opens the page with a robot whose hand carries the OAK, and a region. */
async function openMounted() {
  const opened = await openRobot(browser);
  const { page } = opened;
  await page.getByTestId("mount").selectOption("hand");
  await after(page, () => page.getByTestId("to-link").click());
  await page.getByTestId("tab-place").click();
  await page.getByTestId("target").selectOption("/Room/Shell/Floor");
  return opened;
}

/** The numbers of a row of the table. */
const row = (page, name) => page.getByTestId(`posture-${name}`).locator("td").allTextContents();

/** Saves what a button saves, and returns its text. */
async function saved(page, button) {
  const [download] = await Promise.all([page.waitForEvent("download"), page.getByTestId(button).click()]);
  return readFile(await download.path(), "utf8");
}

test("a motion is measured posture by posture and as a whole, and moves the robot", { skip }, async () => {
  const { page, context, errors } = await openMounted();
  await drop(page, "poses.csv", LIST);
  await page.getByText("It has no column for grip").waitFor();
  const start = await pixels(page, "color");
  await page.getByTestId("run-motion").click();
  const all = page.getByTestId("posture-all");
  await all.waitFor();
  const [, seen, measured] = (await row(page, "all")).map(Number);
  const rows = await Promise.all([0, 1].map((i) => row(page, i)));
  for (const [, own, ownMeasured, hidden] of rows) {
    assert.ok(Number(own) <= seen && Number(ownMeasured) <= measured && Number(hidden) >= 0, `${rows}`);
  }
  assert.ok(seen > 0);
  // The saved table has the same numbers.
  const table = (await saved(page, "motion-csv")).trim().split("\n").map((line) => line.split(","));
  assert.equal((Number(table[1][table[0].indexOf("measured")]) * 100).toFixed(1), measured.toFixed(1));
  assert.equal(table.length, 4);
  await page.getByTestId("motion-command").click();
  assert.match(await page.getByTestId("snippet").textContent(), /printf .* > poses\.csv\n.*oaktwin coverage .*--joints poses\.csv --mount hand --region \/Room\/Shell\/Floor/s);
  await page.keyboard.press("Escape");
  // A click shows a posture; the numbers stay, because the OAK is where it was on its link.
  await after(page, () => page.getByTestId("posture-1").getByRole("button", { name: "1", exact: true }).click());
  assert.notEqual(await pixels(page, "color"), start);
  assert.equal(await page.getByTestId("joint-shoulder").inputValue(), "40");
  assert.equal(await page.getByTestId("posture-1").getAttribute("aria-current"), "true");
  assert.ok(await all.isVisible());
  // Numbers of an OAK that was moved are not shown.
  await after(page, () => page.getByTestId("position-x").fill("1"));
  await all.waitFor({ state: "detached" });
  assert.deepEqual(errors, []);
  await context.close();
});

test("postures are collected, removed, measured until somebody cancels, and kept in a session", { skip }, async () => {
  const { page, context, errors } = await openMounted();
  const postures = page.getByTestId("postures").locator("tbody tr");
  await page.getByTestId("add-posture").click();
  await postures.nth(0).waitFor();
  await after(page, () => page.getByTestId("joint-shoulder").fill("60"));
  await page.getByTestId("add-posture").click();
  await postures.nth(1).waitFor();
  await after(page, () => page.getByTestId("joint-shoulder").fill("70"));
  await page.getByTestId("add-posture").click();
  await postures.nth(2).waitFor();
  await page.getByRole("button", { name: "Remove posture 0" }).click();
  await postures.nth(2).waitFor({ state: "detached" });
  await page.getByTestId("run-motion").click();
  await page.getByTestId("cancel-motion").click();
  await page.getByTestId("run-motion").waitFor();
  assert.equal(await page.getByTestId("posture-all").count(), 0);

  const [state, color] = [await page.evaluate(() => window.studio.document.get()), await pixels(page, "color")];
  await page.getByTestId("export").click();
  const [download] = await Promise.all([page.waitForEvent("download"), page.getByRole("menuitem", { name: "Session" }).click()]);
  const buffer = await readFile(await download.path());
  // What is wrong with a list is said, and changes nothing.
  await drop(page, "wrong.csv", "ellbow\n1\n");
  await page.getByText("no joint 'ellbow' moves").waitFor();
  assert.equal(await page.evaluate(() => window.studio.document.get().motion), state.motion);
  assert.deepEqual(errors.filter((error) => !error.includes("422")), []);
  await context.close();

  const other = await open(browser, { viewport: { width: 1440, height: 900 } });
  await after(other.page, () => other.page.getByTestId("file").setInputFiles({ name: "arm.oaktwin", mimeType: "application/zip", buffer }));
  await rest(other.page);
  assert.deepEqual(await other.page.evaluate(() => window.studio.document.get()), state);
  await other.page.getByTestId("tab-place").click();
  await other.page.getByTestId("posture-1").waitFor();
  assert.equal(await pixels(other.page, "color"), color);
  assert.deepEqual(other.errors, []);
  await other.context.close();
});
