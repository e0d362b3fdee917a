import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { after as afterAll, before, test } from "node:test";
import { difference, read } from "./image.mjs";
import { after, drop, launch, open, openRobot, pixels, rest, skip } from "./page.mjs";

let browser;
before(async () => {
  if (!skip) browser = await launch();
});
afterAll(() => browser?.close());

/** The position and the angles of the selected OAK. */
const pose = (page) => page.locator('.section:has([data-testid="position-x"]) input').evaluateAll((inputs) => inputs.map(({ value }) => Number(value.replace("−", "-"))));

test("an OAK on a link follows the joints, and sees the robot", { skip }, async () => {
  const { page, context, errors } = await openRobot(browser);
  await page.getByTestId("mount").selectOption("hand");
  await after(page, () => page.getByTestId("to-link").click());
  const [start, seen] = [await pose(page), await pixels(page, "color")];
  await after(page, () => page.getByTestId("joint-shoulder").fill("40"));
  const bent = await pose(page);
  // 0.3 m of upper arm and 0.35 m of forearm, 80.2 degrees further, about a shoulder 0.2 m above the floor.
  const reach = Math.hypot(bent[0], bent[2] - 0.2);
  assert.ok(Math.abs(reach - Math.hypot(start[0], start[2] - 0.2)) < 2e-3, "the hand turns about the shoulder");
  assert.ok(Math.abs(start[4] + 40 - bent[4]) < 0.1 || Math.abs(bent[0] - start[0]) > 0.05, "and so does the OAK");
  assert.notEqual(await pixels(page, "color"), seen);
  // Released, it stays where it is.
  await page.getByTestId("mount").selectOption("");
  await after(page, () => page.getByTestId("joint-shoulder").fill("0"));
  assert.deepEqual(await pose(page), bent);
  // Undo restores posture and pose.
  assert.deepEqual(errors, []);
  await context.close();
});

test("the 3D view and the coverage have the robot", { skip }, async () => {
  const { page, context, errors } = await openRobot(browser);
  const view = async () => {
    await rest(page);
    return read(page, await page.getByTestId("view").screenshot());
  };
  const upright = await view();
  await after(page, () => page.getByTestId("slide-shoulder").evaluate((slider) => {
    slider.value = "60";
    slider.dispatchEvent(new Event("input", { bubbles: true }));
  }));
  assert.ok(difference(upright, await view(), 20).share > 0.0005, "the arm moves in the 3D view");
  await page.getByTestId("mount").selectOption("fore");
  await after(page, () => page.getByTestId("to-link").click());
  await page.getByTestId("tab-place").click();
  await page.getByTestId("target").selectOption("/Room/Shell/Floor");
  const own = page.getByTestId("own-robot").locator("td").first();
  await own.waitFor();
  assert.ok(Number.parseFloat(await own.textContent()) >= 0);
  assert.deepEqual(errors, []);
  await context.close();
});

test("a session keeps the robot and its posture", { skip }, async () => {
  const { page, context, errors } = await openRobot(browser);
  await after(page, () => page.getByTestId("joint-shoulder").fill("40"));
  const [state, color] = [await page.evaluate(() => window.studio.document.get()), await pixels(page, "color")];
  assert.match(state.scene, /~/);
  await page.getByTestId("export").click();
  const [download] = await Promise.all([page.waitForEvent("download"), page.getByRole("menuitem", { name: "Session" }).click()]);
  const buffer = await readFile(await download.path());
  assert.deepEqual(errors, []);
  await context.close();

  const other = await open(browser, { viewport: { width: 1440, height: 900 } });
  await after(other.page, () => other.page.getByTestId("file").setInputFiles({ name: "arm.oaktwin", mimeType: "application/zip", buffer }));
  await other.page.getByTestId("robot").waitFor();
  await rest(other.page);
  assert.deepEqual(await other.page.evaluate(() => window.studio.document.get()), state);
  assert.equal(await other.page.getByTestId("joint-shoulder").inputValue(), "40");
  assert.equal(await pixels(other.page, "color"), color);
  assert.deepEqual(other.errors, []);
  await other.context.close();
});

test("what is wrong with a robot is said", { skip }, async () => {
  const { page, context } = await open(browser);
  await drop(page, "two.urdf", "<robot><link name='a'/><link name='b'/></robot>");
  await page.getByText("is a second base").waitFor();
  await context.close();
});
