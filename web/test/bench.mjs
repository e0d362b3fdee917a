// Times the page in a browser: `npm run bench`, with the address of a server in OAKTWIN_STUDIO_URL.
import { spawn } from "node:child_process";
import { launch, open, rest } from "./page.mjs";

const ROUNDS = 15;

/** Returns the times from the movement of a slider to new pixels on the page, ms. */
async function slider(page, parameter) {
  return page.evaluate(async ([parameter, rounds]) => {
    const input = document.querySelector(`[data-parameter="${parameter}"] input[type="range"]`);
    const set = Object.getOwnPropertyDescriptor(HTMLInputElement.prototype, "value").set;
    const [least, most] = [Number(input.min), Number(input.max)];
    const frame = () => new Promise((resolve) => requestAnimationFrame(resolve));
    const times = [];
    for (let round = 0; round < rounds; round++) {
      while (!window.studio.isIdle) await frame();
      const { painted, received } = window.studio;
      const start = performance.now();
      set.call(input, String(least + (most - least) * (0.2 + 0.5 * ((round * 7) % rounds) / rounds)));
      input.dispatchEvent(new Event("input", { bubbles: true }));
      while (window.studio.received === received || window.studio.painted === painted) await frame();
      times.push(performance.now() - start);
    }
    return times;
  }, [parameter, ROUNDS]);
}

/**
 * Returns the times from a change of the OAK's pose to new pixels on the page, ms: at rest, or while images for rest are being computed, which
 * begins 150 ms after the previous change.
 */
async function move(page, isAtRest) {
  return page.evaluate(async ([rounds, isAtRest]) => {
    const frame = () => new Promise((resolve) => requestAnimationFrame(resolve));
    const times = [];
    for (let round = 0; round < rounds; round++) {
      if (isAtRest) while (!window.studio.isIdle) await frame();
      else await new Promise((resolve) => setTimeout(resolve, 230));
      const { painted, received, document } = window.studio;
      const start = performance.now();
      document.commit("bench", (before) => ({
        ...before,
        oaks: before.oaks.map((oak) => {
          const [x, ...others] = oak.state.pose.position;
          return { ...oak, state: { ...oak.state, pose: { ...oak.state.pose, position: [x + 0.02 * (round % 2 ? -1 : 1), ...others] } } };
        }),
      }));
      while (window.studio.received === received || window.studio.painted === painted) await frame();
      times.push(performance.now() - start);
    }
    return times;
  }, [ROUNDS, isAtRest]);
}

/** Runs something beside two loops that do nothing but take the processor. */
async function busy(run) {
  const loops = [1, 2].map(() => spawn(process.execPath, ["-e", "for (;;);"]));
  try {
    return await run();
  } finally {
    for (const loop of loops) loop.kill("SIGKILL");
  }
}

/** Returns the frames per second that the panels show while the OAK flies. */
async function flight(page) {
  await page.getByTestId("view").focus();
  await page.keyboard.press("f");
  await page.keyboard.down("w");
  const rate = await page.evaluate(async () => {
    const wait = (time) => new Promise((resolve) => setTimeout(resolve, time));
    await wait(500);
    const [before, start] = [window.studio.received, performance.now()];
    await wait(2000);
    return (1000 * (window.studio.received - before)) / (performance.now() - start);
  });
  await page.keyboard.up("w");
  await page.keyboard.press("Escape");
  await rest(page);
  return rate;
}

const median = (values) => [...values].sort((a, b) => a - b)[Math.floor(values.length / 2)];

const browser = await launch();
const started = performance.now();
// Usable: images are there, the 3D view is drawn and controls answer. The images of full size follow.
let usable = 0;
const shown = (page) => page.waitForFunction(() => window.studio?.painted >= 4 && window.studio.drawn > 0, null, { polling: 10 });
const { page } = await open(browser, { fullSize: "large", opened: async (page) => {
  await shown(page);
  usable = performance.now() - started;
} });
const lines = [["usable after", `${Math.round(usable)} ms`], ["images of full size after", `${Math.round(performance.now() - started)} ms`]];
for (const [engine, parameter] of [["stereo-noise", "bias"], ["single-view", "noiseSigma"], ["stereo-matching", "confidenceThreshold"]]) {
  await page.getByTestId("engine").selectOption(engine);
  await page.waitForTimeout(300);
  await rest(page);
  for (const [option, size] of [["small", "640 × 400"], ["large", "1280 × 800"]]) {
    await page.getByTestId("full-size").selectOption(option);
    await page.waitForTimeout(300);
    await rest(page);
    const times = await slider(page, parameter);
    lines.push([`${engine}, ${size}`, `${Math.round(median(times))} ms (${Math.round(Math.min(...times))} to ${Math.round(Math.max(...times))})`]);
  }
}
for (const [beside, run] of [["", (task) => task()], [", beside two busy loops", busy]]) {
  for (const engine of ["stereo-noise", "stereo-matching"]) {
    await page.getByTestId("engine").selectOption(engine);
    await page.waitForTimeout(300);
    await rest(page);
    for (const [title, isAtRest] of [["moving from rest", true], ["moving on while images for rest are computed", false]]) {
      const times = await run(() => move(page, isAtRest));
      lines.push([`${engine}, ${title}${beside}`, `${Math.round(median(times))} ms (${Math.round(Math.min(...times))} to ${Math.round(Math.max(...times))})`]);
    }
    lines.push([`${engine}, while flying${beside}`, `${(await run(() => flight(page))).toFixed(1)} frames/s`]);
  }
}
for (const [name, value] of lines) console.log(`| ${name} | ${value} |`);
await browser.close();
