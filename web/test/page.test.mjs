import assert from "node:assert/strict";
import { mkdtemp, readFile, rm, truncate, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after as afterAll, before, test } from "node:test";
import { PATIENCE, addressAfter, after, drop, launch, open, pixels, rest, skip, url } from "./page.mjs";

let browser;
before(async () => {
  if (!skip) browser = await launch();
});
afterAll(() => browser?.close());

/** Moves the first slider of the parameters by keys. */
async function moveSlider(page) {
  const slider = page.locator('[data-testid="parameter-group"] input[type="range"]').last();
  await slider.focus();
  for (let i = 0; i < 5; i++) await page.keyboard.press("PageUp");
}

test("the page loads without errors", { skip }, async () => {
  const { page, context, errors } = await open(browser);
  assert.match(await page.title(), /oaktwin/);
  assert.notEqual(await page.getByTestId("scene").textContent(), "Loading…");
  for (const kind of ["color", "depth", "sensor", "error"]) {
    const isPlain = await page.evaluate((id) => {
      const shown = document.querySelector(`[data-testid="${id}"] canvas`);
      const canvas = new OffscreenCanvas(shown.width, shown.height);
      canvas.getContext("2d").drawImage(shown, 0, 0);
      const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
      return data.every((value, i) => value === data[i % 4]);
    }, `panel-oak1-${kind}`);
    assert.equal(isPlain, false, `${kind} shows something`);
  }
  assert.deepEqual(errors, []);
  await context.close();
});

test("a slider changes the pixels, and undo restores them", { skip }, async () => {
  const { page, context, errors } = await open(browser);
  const original = await pixels(page, "sensor");
  const parameters = page.locator('[data-parameter="bias"] input[type="text"]');
  await after(page, () => parameters.fill("0.5"));
  assert.notEqual(await pixels(page, "sensor"), original);
  await after(page, () => page.keyboard.press("Control+z"));
  assert.equal(await pixels(page, "sensor"), original);
  await after(page, () => moveSlider(page));
  assert.ok((await page.locator(".parameter.changed").count()) > 0, "a changed parameter is marked");
  await after(page, () => page.getByTestId("reset-all").click());
  assert.equal(await pixels(page, "sensor"), original);
  assert.deepEqual(errors, []);
  await context.close();
});

test("a value out of range marks its field and sends nothing", { skip }, async () => {
  const { page, context } = await open(browser);
  const received = await page.evaluate(() => window.studio.received);
  const field = page.locator('[data-parameter="bias"] input[type="text"]');
  await field.fill("1e9");
  assert.equal(await field.getAttribute("aria-invalid"), "true");
  await rest(page);
  assert.equal(await page.evaluate(() => window.studio.received), received);
  await context.close();
});

test("a broken file is reported, and the previous scene stays", { skip }, async () => {
  const { page, context } = await open(browser);
  const scene = await page.getByTestId("scene").textContent();
  await drop(page, "broken.usda", "#usda 1.0\ndef Mesh {");
  const notice = page.getByTestId("notice").first();
  await notice.waitFor();
  assert.match(await notice.textContent(), /broken\.usda/);
  assert.equal(await page.getByTestId("scene").textContent(), scene);
  await context.close();
});

test("a broken calibration and a file that is too large change nothing", { skip }, async () => {
  const { page, context } = await open(browser);
  const address = page.url();
  await drop(page, "unit.json", "{}");
  await page.getByTestId("notice").filter({ hasText: "unit.json" }).waitFor();
  await page.route("**/api/catalog", async (route) => {
    const response = await route.fetch();
    await route.fulfill({ response, json: { ...(await response.json()), maxUploadBytes: 10 } });
  });
  await page.reload();
  await rest(page);
  const uploads = [];
  page.on("request", (request) => request.method() === "POST" && request.url().includes("/api/scenes") && uploads.push(request.url()));
  await drop(page, "large.glb", "x".repeat(100));
  await page.getByTestId("notice").filter({ hasText: "large.glb" }).waitFor();
  assert.deepEqual(uploads, [], "a file that is too large is not sent");
  assert.equal(page.url(), address);
  await context.close();
});

test("a dropped file of 500 MB is refused before it is sent", { skip }, async () => {
  const { page, context } = await open(browser);
  const folder = await mkdtemp(join(tmpdir(), "oaktwin-"));
  const path = join(folder, "huge.glb");
  await writeFile(path, "");
  // It has no data on the disk.
  await truncate(path, 500e6);
  const uploads = [];
  page.on("request", (request) => request.method() === "POST" && uploads.push(request.url()));
  const scene = await page.getByTestId("scene").textContent();
  await page.evaluate(() => {
    const input = document.createElement("input");
    input.type = "file";
    input.id = "source";
    input.hidden = true;
    document.body.append(input);
  });
  await page.locator("#source").setInputFiles(path);
  await page.evaluate(() => {
    const dataTransfer = new DataTransfer();
    dataTransfer.items.add(document.getElementById("source").files[0]);
    window.dispatchEvent(new DragEvent("drop", { dataTransfer, cancelable: true, bubbles: true }));
  });
  const notice = page.getByTestId("notice").filter({ hasText: "huge.glb" });
  await notice.waitFor();
  assert.match(await notice.textContent(), /500/);
  assert.deepEqual(uploads, []);
  assert.equal(await page.getByTestId("scene").textContent(), scene);
  await rm(folder, { recursive: true });
  await context.close();
});

test("images are exported as shown", { skip }, async () => {
  const { page, context, errors } = await open(browser);
  await page.getByTestId("export").click();
  const [download] = await Promise.all([page.waitForEvent("download"), page.getByRole("menuitem", { name: "As shown" }).click()]);
  const bytes = await readFile(await download.path());
  assert.equal(bytes.subarray(1, 4).toString(), "PNG");
  assert.ok(bytes.length > 10_000);
  assert.deepEqual(errors, []);
  await context.close();
});

test("the page fits windows of all sizes", { skip }, async () => {
  const { page, context, errors } = await open(browser);
  for (const [width, height] of [[1024, 700], [1920, 1080], [3840, 2160], [1280, 800]]) {
    await page.setViewportSize({ width, height });
    await rest(page);
    const size = await page.evaluate(() => [document.documentElement.scrollWidth, document.documentElement.scrollHeight]);
    assert.deepEqual(size, [width, height]);
    const outside = await page.evaluate(() => [...document.querySelectorAll(".top-bar > *")].filter((element) => {
      const { right, width } = element.getBoundingClientRect();
      return width > 0 && right > innerWidth + 1;
    }).length);
    assert.equal(outside, 0, `at ${width} × ${height} the bar fits`);
  }
  assert.deepEqual(errors, []);
  await context.close();
});

test("two tabs do not disturb each other", { skip }, async () => {
  const first = await open(browser);
  const second = await open(browser);
  const original = await pixels(first.page, "sensor");
  await after(second.page, () => second.page.locator('[data-parameter="bias"] input[type="text"]').fill("0.5"));
  assert.equal(await pixels(first.page, "sensor"), original);
  assert.notEqual(await pixels(second.page, "sensor"), original);
  assert.deepEqual([...first.errors, ...second.errors], []);
  await first.context.close();
  await second.context.close();
});

test("the theme can be chosen and is remembered", { skip }, async () => {
  const { page, context } = await open(browser, { colorScheme: "light" });
  const background = () => page.evaluate(() => getComputedStyle(document.querySelector(".side")).backgroundColor);
  const light = await background();
  await page.getByTestId("theme").click();
  const dark = await background();
  assert.notEqual(dark, light);
  await page.goto(url);
  await rest(page);
  assert.equal(await background(), dark);
  await context.close();
});

test("the page can be used by keyboard", { skip }, async () => {
  const { page, context, errors } = await open(browser);
  await page.evaluate(() => {
    const observer = new MutationObserver(() => {
      const dialog = document.querySelector("dialog");
      if (dialog) window.wasOpenAtOnce ??= dialog.open;
    });
    observer.observe(document.body, { childList: true, subtree: true });
  });
  await page.keyboard.press("?");
  await page.getByRole("dialog").waitFor();
  assert.equal(await page.evaluate(() => window.wasOpenAtOnce), true, "keys reach the dialogue as soon as it appears");
  await page.keyboard.press("Escape");
  await page.getByRole("dialog").waitFor({ state: "detached" });
  const position = page.getByTestId("position-x");
  const before = await position.inputValue();
  await page.getByTestId("view").focus();
  await after(page, () => page.keyboard.press("ArrowUp"));
  assert.notEqual(await position.inputValue(), before);
  await position.focus();
  await after(page, () => page.keyboard.press("ArrowUp"));
  const unnamed = await page.evaluate(() => [...document.querySelectorAll("button, input:not([hidden]), select")].filter((element) => {
    const label = element.getAttribute("aria-label") ?? element.closest("label")?.textContent ?? element.textContent;
    return !label?.trim();
  }).length);
  assert.equal(unnamed, 0, "every control has a name");
  await page.locator(".surface").first().focus();
  await page.keyboard.press("ArrowRight");
  await page.locator('[data-testid="readout"] dl').waitFor();
  assert.deepEqual(errors, []);
  await context.close();
});

test("an OAK flies with the view", { skip }, async () => {
  const { page, context, errors } = await open(browser);
  const before = await page.getByTestId("position-x").inputValue();
  await page.getByTestId("view").focus();
  await page.keyboard.press("f");
  await after(page, async () => {
    await page.keyboard.down("w");
    await page.waitForFunction((before) => document.querySelector('[data-testid="position-x"]').value !== before, before);
    await page.keyboard.up("w");
  });
  await page.keyboard.press("Escape");
  await after(page, () => page.keyboard.press("Control+z"));
  assert.equal(await page.getByTestId("position-x").inputValue(), before, "a flight is one step of undo");
  assert.deepEqual(errors, []);
  await context.close();
});

test("assistive technology finds its way in both themes", { skip }, async () => {
  const axe = await readFile(new URL("../node_modules/axe-core/axe.min.js", import.meta.url), "utf8");
  for (const colorScheme of ["light", "dark"]) {
    const { page, context } = await open(browser, { bypassCSP: true, colorScheme });
    await page.addScriptTag({ content: axe });
    await after(page, () => page.getByTestId("show-reason").click());
    const check = async (part) => {
      const runOnly = ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "best-practice"];
      const violations = await page.evaluate(async (runOnly) => (await window.axe.run(document, { runOnly })).violations, runOnly);
      assert.deepEqual(violations.map(({ id, nodes }) => [id, nodes.map(({ html }) => html)]), [], `${part}, ${colorScheme}`);
    };
    await check("images and numbers");
    await page.getByTestId("tab-place").click();
    await page.getByTestId("target").selectOption("/Room/Table/Top");
    await check("placement");
    await page.keyboard.press("?");
    await check("keys");
    await context.close();
  }
});

test("the coverage of an object is measured, and a sweep ranks poses", { skip }, async () => {
  const { page, context, errors } = await open(browser);
  await page.getByTestId("tab-place").click();
  await page.getByTestId("target").selectOption("/Room/Table/Top");
  const share = (table, column) => page.locator(table).evaluate((table, column) => {
    return [...table.rows].slice(1).map((row) => Number.parseFloat(row.cells[column].textContent));
  }, column);
  const coverage = '[data-testid="coverage"] table';
  await page.locator(coverage).waitFor();
  assert.ok((await share(coverage, 1)).every((value) => value >= 0));
  await page.getByTestId("sweep").getByLabel("steps").first().fill("2");
  await page.getByTestId("run-sweep").click();
  await page.locator('[data-testid="sweep"] [role="status"]').waitFor();
  await page.locator('[data-testid="sweep"] [role="status"]').waitFor({ state: "detached" });
  const measured = await share("table.ranking", 2);
  assert.equal(measured.length, 6);
  assert.deepEqual(measured, measured.toSorted((a, b) => b - a), "the best pose is the first");
  assert.deepEqual(errors, []);
  await context.close();
});

test("OAKs can be added, compared and removed", { skip }, async () => {
  const { page, context, errors } = await open(browser);
  await after(page, () => page.getByTestId("duplicate").click());
  assert.equal(await pixels(page, "sensor", "oak2"), await pixels(page, "sensor", "oak1"), "a duplicate measures the same");
  const models = await page.getByTestId("add-oak").locator("option").allTextContents();
  assert.ok(models.length > 2);
  await page.getByTestId("oaks").getByRole("button", { name: "Remove" }).last().click();
  await page.waitForFunction(() => document.querySelectorAll('[data-testid="oaks"] > li').length === 1);
  await rest(page);
  assert.deepEqual(errors, []);
  await context.close();
});

test("the address restores the state", { skip }, async () => {
  const { page, context } = await open(browser);
  const hash = await addressAfter(page, () => page.locator('[data-parameter="bias"] input[type="text"]').fill("0.5"));
  const changed = await pixels(page, "sensor");
  const other = await open(browser, { path: hash });
  assert.equal(await pixels(other.page, "sensor"), changed);
  await other.context.close();
  await context.close();
});

test("the page reconnects to a server that was restarted, and says so", { skip }, async () => {
  const { page, context } = await open(browser);
  let isDown = false;
  let socket;
  await page.routeWebSocket(/api\/live/, (route) => {
    if (isDown) return route.close();
    socket = route;
    route.connectToServer();
  });
  await page.reload();
  await rest(page);
  isDown = true;
  await socket.close();
  await page.getByTestId("lost").waitFor();
  isDown = false;
  await page.getByTestId("lost").waitFor({ state: "detached" });
  await page.getByTestId("notice").filter({ hasText: "again" }).waitFor();
  await rest(page);
  await after(page, () => page.locator('[data-parameter="bias"] input[type="text"]').fill("0.5"));
  await context.close();
});

test("a browser without WebGL 2 gets an explanation", { skip }, async () => {
  const plain = await launch(["--disable-3d-apis"]);
  const page = await plain.newPage();
  page.setDefaultTimeout(PATIENCE);
  await page.goto(url);
  await page.getByRole("alert").waitFor();
  assert.match(await page.getByRole("alert").textContent(), /WebGL 2/);
  await plain.close();
});
