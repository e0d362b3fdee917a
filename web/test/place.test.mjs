import assert from "node:assert/strict";
import { after as afterAll, before, test } from "node:test";
import { difference, read } from "./image.mjs";
import { launch, open, rest, skip } from "./page.mjs";

let browser;
before(async () => {
  if (!skip) browser = await launch();
});
afterAll(() => browser?.close());

async function openPlace() {
  const opened = await open(browser, { viewport: { width: 1440, height: 900 } });
  await opened.page.getByTestId("tab-place").click();
  return opened;
}

async function view(page) {
  await rest(page);
  return read(page, await page.getByTestId("view").screenshot());
}

/** The places on the page of what has the colour of handles: squares of such pixels. */
async function handles(page) {
  const { width, height, data } = await view(page);
  const { x, y } = await page.getByTestId("view").boundingBox();
  const isPink = (column, row) => {
    const [red, green, blue] = data.subarray((row * width + column) * 4, (row * width + column) * 4 + 3);
    return red > 150 && green < 120 && blue > 100 && red > blue;
  };
  const side = [-2, -1, 0, 1, 2];
  const found = [];
  for (let row = 3; row < height - 3; row++) {
    for (let column = 3; column < width - 3; column++) {
      if (!side.every((down) => side.every((right) => isPink(column + right, row + down)))) continue;
      if (found.every(([left, top]) => Math.hypot(left - x - column, top - y - row) > 16)) found.push([x + column, y + row]);
    }
  }
  return found;
}

const fields = (page) => page.locator('[data-testid="region"] .triple input').evaluateAll((inputs) => inputs.map(({ value }) => Number(value.replace("−", "-"))));

test("the surface of a region is painted with what the OAK measures of it", { skip }, async () => {
  const { page, context, errors } = await openPlace();
  const plain = await view(page);
  await page.getByTestId("target").selectOption("/Room/Shell/Floor");
  await page.locator('[data-testid="coverage"] table').waitFor();
  const measured = () => page.locator('[data-testid="coverage"] tr', { hasText: "Measured" }).locator("td").first().textContent().then(Number.parseFloat);
  const painted = await view(page);
  await page.getByLabel("Paint the surface").uncheck();
  const outlined = await view(page);
  assert.ok(difference(painted, outlined, 20).share > 0.002, "paint is visible");
  assert.ok(difference(plain, outlined, 20).share < difference(plain, painted, 20).share, "only the outline remains");
  assert.ok((await measured()) >= 0);
  assert.deepEqual(errors, []);
  await context.close();
});

test("a click chooses an object, and a box is resized and moved by its handles", { skip }, async () => {
  const { page, context, errors } = await openPlace();
  await page.getByRole("button", { name: "Click an object" }).click();
  const canvas = await page.getByTestId("view").boundingBox();
  await page.mouse.click(canvas.x + canvas.width * 0.5, canvas.y + canvas.height * 0.5);
  assert.notEqual(await page.getByTestId("target").inputValue(), "", "an object is chosen");
  await page.getByRole("button", { name: "Clear" }).click();

  await page.getByRole("button", { name: "Box", exact: true }).click();
  const before = await fields(page);
  assert.equal(before.length, 6);
  const position = await page.getByTestId("position-x").inputValue();
  const places = await handles(page);
  assert.ok(places.length >= 4, `${places.length} handles are visible`);
  const changed = new Set();
  for (const [x, y] of places) {
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + 12, y - 9, { steps: 3 });
    await page.mouse.up();
    const moved = (await fields(page)).flatMap((value, i) => (Math.abs(value - before[i]) > 1e-6 ? [i] : []));
    for (const i of moved) changed.add(i);
    await page.keyboard.press("Control+z");
    assert.deepEqual(await fields(page), before, "a drag is one step of undo");
  }
  assert.ok(changed.size >= 4, `the handles change ${changed.size} of the 6 numbers`);
  assert.equal(await page.getByTestId("position-x").inputValue(), position, "the OAK stays");
  await page.locator('[data-testid="coverage"] table').waitFor();
  assert.deepEqual(errors, []);
  await context.close();
});
