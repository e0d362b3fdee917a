// Reflectances in the infrared, which belong to the scene: all OAKs, links, undo and exports have them.
import assert from "node:assert/strict";
import { after as afterAll, before, test } from "node:test";
import { addressAfter, after, launch, open, pixels, skip } from "./page.mjs";

let browser;
before(async () => {
  if (!skip) browser = await launch();
});
afterAll(() => browser?.close());

/** The text that an entry of the menu *Export* shows. */
async function exported(page, name) {
  await page.getByTestId("export").click();
  await page.getByRole("menuitem", { name }).click();
  const text = await page.getByTestId("snippet").textContent();
  await page.keyboard.press("Escape");
  return text;
}

test("a material gets a reflectance, which changes what is measured and is exported", { skip }, async () => {
  const { page, context, errors } = await open(browser);
  await after(page, () => page.getByTestId("model").selectOption("OAK-D ToF"));
  const usual = [await pixels(page, "sensor"), await pixels(page, "color")];
  await page.getByRole("button", { name: "Colours and glass" }).click();
  const offered = await page.getByTestId("add-infrared").locator("option").allTextContents();
  assert.ok(offered.includes("Carpet") && offered.includes("Leaf"), offered.join());
  await after(page, () => page.getByTestId("add-infrared").selectOption("Carpet"));
  const field = page.getByTestId("infrared-Carpet");
  const hash = await addressAfter(page, () => field.fill("0.02"));
  const dark = await pixels(page, "sensor");
  assert.notEqual(dark, usual[0]);
  assert.equal(await pixels(page, "color"), usual[1], "colours do not see it");
  assert.equal(await page.evaluate(() => window.studio.document.get().scene), "first;Carpet=0.02");
  assert.ok(!(await page.getByTestId("add-infrared").locator("option").allTextContents()).includes("Carpet"));
  assert.match(await exported(page, "Command line"), /--infrared Carpet=0\.02 /);
  assert.match(await exported(page, "Python"), /infrared=\{"Carpet": 0\.02\}/);
  await field.fill("1.5");
  assert.equal(await field.getAttribute("aria-invalid"), "true");
  await field.blur();

  const other = await open(browser, { path: hash });
  assert.equal(await pixels(other.page, "sensor"), dark, "a link has it");
  assert.equal(await other.page.getByTestId("infrared-Carpet").inputValue(), "0.02");
  assert.deepEqual(other.errors, []);
  await other.context.close();

  await after(page, () => page.getByRole("button", { name: "Remove the reflectance of Carpet" }).click());
  assert.equal(await pixels(page, "sensor"), usual[0]);
  await after(page, () => page.keyboard.press("Control+z"));
  assert.equal(await pixels(page, "sensor"), dark, "undo restores it");
  assert.deepEqual(errors, []);
  await context.close();
});
