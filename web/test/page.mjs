// Opens the page in a browser for the tests.
import { createHash } from "node:crypto";
import { existsSync } from "node:fs";
import { readFile } from "node:fs/promises";
import { chromium } from "playwright-core";

/** The address of a running `oaktwin studio`. */
export const url = process.env.OAKTWIN_STUDIO_URL;

/** Milliseconds in which everything happens, however busy the machine is. */
export const PATIENCE = 300_000;

const ROBOT = new URL("../../examples/robots/gripper.urdf", import.meta.url);

const executablePath = process.env.OAKTWIN_BROWSER ?? "/usr/bin/chromium";

/** Why the tests in a browser cannot run; false if they can. */
export const skip = !url ? "OAKTWIN_STUDIO_URL is not set" : !existsSync(executablePath) ? `${executablePath} does not exist` : false;

export async function launch(args = []) {
  return chromium.launch({ executablePath, timeout: PATIENCE, args: ["--no-sandbox", ...args] });
}

/**
 * Opens the page and waits for its first images. `errors` collects what the console and the page report. Images at rest are small unless a
 * test is about large ones, because a server of a debug build takes seconds for those.
 */
export async function open(browser, { path = "", viewport = { width: 1280, height: 800 }, fullSize = "small", opened = async () => {}, ...options } = {}) {
  const context = await browser.newContext({ viewport, ...options });
  await context.addInitScript((size) => {
    const key = "oaktwin-studio-display";
    localStorage.setItem(key, JSON.stringify({ fullSize: size, ...JSON.parse(localStorage.getItem(key) ?? "{}") }));
  }, fullSize);
  context.setDefaultTimeout(PATIENCE);
  const page = await context.newPage();
  const errors = [];
  page.on("console", (message) => message.type() === "error" && errors.push(message.text()));
  page.on("pageerror", (error) => errors.push(String(error)));
  await page.goto(url + path, { waitUntil: "commit" });
  await opened(page);
  await rest(page);
  return { page, context, errors };
}

/** Opens the page and drops the robot of the examples onto it. */
export async function openRobot(browser) {
  const opened = await open(browser, { viewport: { width: 1440, height: 900 } });
  const text = await readFile(ROBOT, "utf8");
  await after(opened.page, () => drop(opened.page, "gripper.urdf", text));
  await opened.page.getByTestId("robot").waitFor();
  return opened;
}

/** Waits until every image is there and drawn. */
export async function rest(page) {
  await page.waitForFunction(() => window.studio?.isIdle && window.studio.painted > 0 && window.studio.drawn > 0);
}

/** Runs an action and waits for the images that it causes. */
export async function after(page, action) {
  const before = await page.evaluate(() => window.studio.received);
  await action();
  await page.waitForFunction((before) => window.studio.received > before, before);
  await rest(page);
}

/** Runs an action, waits for the images and the address that it causes, and returns the state in the address. */
export async function addressAfter(page, action) {
  const before = new URL(page.url()).hash;
  await after(page, action);
  await page.waitForFunction((before) => location.hash !== before, before);
  return page.evaluate(() => location.hash);
}

/** Returns a digest of the pixels of an image panel, to compare them. */
export async function pixels(page, kind, oak = "oak1") {
  const data = await page.evaluate((id) => document.querySelector(`[data-testid="${id}"] canvas`).toDataURL(), `panel-${oak}-${kind}`);
  return createHash("sha256").update(data).digest("hex");
}

/** Drops a file onto the page. */
export async function drop(page, name, text) {
  await page.evaluate(([name, text]) => {
    const dataTransfer = new DataTransfer();
    dataTransfer.items.add(new File([text], name));
    for (const type of ["dragover", "drop"]) window.dispatchEvent(new DragEvent(type, { dataTransfer, cancelable: true, bubbles: true }));
  }, [name, text]);
}

/** Drops a mesh file, and opens it in the units that the page guesses. */
export async function dropScene(page, name, text) {
  await drop(page, name, text);
  await page.getByTestId("use-scene").click();
  await page.waitForFunction((name) => document.querySelector('[data-testid="scene"]').textContent.includes(name), name);
}
