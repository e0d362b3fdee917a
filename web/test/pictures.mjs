// Takes the pictures of the page: `npm run pictures -- FOLDER [NAME…]`, with the address of a server in OAKTWIN_STUDIO_URL. The manual's go
// into the folder, and those that the tests compare into `test/looks`. With names, only those of the manual's steps are taken.
import { mkdir, readFile, writeFile } from "node:fs/promises";
import { record } from "./film.mjs";
import { FOLDER, LOOKS, openLook, small } from "./looks.mjs";
import { scaled } from "./image.mjs";
import { after, drop, launch, open, rest } from "./page.mjs";

const [, , folder = ".", ...names] = process.argv;
const ROBOT = new URL("../../examples/robots/gripper.urdf", import.meta.url);
const browser = await launch();

async function film() {
  const { page, context } = await open(browser, { viewport: { width: 1280, height: 800 }, colorScheme: "dark", fullSize: "large" });
  await writeFile(`${folder}/studio.webp`, (await record(page)).file());
  await context.close();
}

async function looks() {
  await mkdir(FOLDER, { recursive: true });
  for (const look of LOOKS) {
    const { page, context } = await openLook(browser, look);
    await writeFile(`${FOLDER}${look.name}.png`, await small(page));
    await context.close();
  }
}

/** Puts a robot into the scene, whose hand carries the OAK. */
async function carry(page) {
  await after(page, async () => drop(page, "gripper.urdf", await readFile(ROBOT, "utf8")));
  for (const [field, value] of [["joint-shoulder", -20], ["joint-elbow", 110], ["joint-grip", 0.03], ["position-x", 0.02], ["position-z", 0.64]]) {
    await after(page, () => page.getByTestId(field).fill(String(value)));
  }
  await page.getByTestId("mount").selectOption("hand");
  await after(page, () => page.getByTestId("joint-turn").fill("8"));
}

/** The main steps, for the manual: of the whole page, or of a part of it. */
const STEPS = [
  {
    name: "studio_compare",
    show: async (page) => {
      await after(page, () => page.getByTestId("add-oak").selectOption({ label: "OAK-D Lite" }));
      await after(page, () => page.getByTestId("add-oak").selectOption({ label: "OAK-D ToF" }));
    },
  },
  {
    name: "studio_move",
    show: async (page) => {
      const { position: [x, y, z], quaternion } = await page.evaluate(() => window.studio.document.get().oaks[0].state.pose);
      const line = (k) => [k / 10, x + 0.02 * k, y + 0.3 * Math.sin(k / 12), z, ...quaternion].join(" ");
      await after(page, () => drop(page, "path.txt", Array.from({ length: 60 }, (_, k) => line(k)).join("\n")));
      await after(page, () => page.getByTestId("frame").fill("34"));
      await page.getByTestId("notice").waitFor({ state: "detached" });
    },
  },
  {
    name: "studio_robot",
    show: async (page) => {
      await carry(page);
      await page.getByTestId("notice").waitFor({ state: "detached" });
    },
  },
  {
    name: "studio_motion",
    part: "motion",
    show: async (page) => {
      await carry(page);
      await page.getByTestId("tab-place").click();
      await page.getByTestId("target").selectOption("/Room/Shell/Floor");
      await drop(page, "reach.csv", "turn_deg,shoulder_deg,elbow_deg,grip\n0,-20,110,0\n8,-20,110,0.03\n8,-5,85,0.03\n-15,-30,120,0.03\n");
      await page.getByTestId("run-motion").click();
      await page.getByTestId("posture-all").waitFor();
      await page.waitForFunction(() => document.querySelectorAll('[data-testid="notice"]').length === 0);
    },
  },
  {
    name: "studio_place",
    colorScheme: "dark",
    show: async (page) => {
      await page.getByTestId("tab-place").click();
      await page.getByTestId("target").selectOption("/Room/Table/Top");
      await page.locator('[data-testid="coverage"] table').waitFor();
    },
  },
];

async function steps() {
  const wanted = STEPS.filter(({ name }) => names.length === 0 || names.includes(name));
  for (const { name, show, part, colorScheme = "light" } of wanted) {
    // A part has few words, which stay sharp.
    const [deviceScaleFactor, width] = part ? [2, 480] : [1, 1200];
    const { page, context } = await open(browser, { viewport: { width: 1440, height: 900 }, deviceScaleFactor, colorScheme, fullSize: "large" });
    await show(page);
    await rest(page);
    await writeFile(`${folder}/${name}.webp`, await scaled(page, await (part ? page.getByTestId(part) : page).screenshot(), width, "image/webp"));
    await context.close();
  }
}

await steps();
if (names.length === 0) {
  await film();
  await looks();
}
await browser.close();
