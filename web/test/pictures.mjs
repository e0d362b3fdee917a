// Takes the pictures of the page: `npm run pictures -- FOLDER`, with the address of a server in OAKTWIN_STUDIO_URL. The manual's goes
// into the folder, and those that the tests compare into `test/looks`.
import { mkdir, writeFile } from "node:fs/promises";
import { record } from "./film.mjs";
import { FOLDER, LOOKS, openLook, small } from "./looks.mjs";
import { scaled } from "./image.mjs";
import { after, drop, launch, open, rest } from "./page.mjs";

const [, , folder = "."] = process.argv;
const browser = await launch();

async function film() {
  const { page, context } = await open(browser, { viewport: { width: 1280, height: 800 }, colorScheme: "dark" });
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

/** The main steps, for the manual. */
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
  for (const { name, show, colorScheme = "light" } of STEPS) {
    const { page, context } = await open(browser, { viewport: { width: 1440, height: 900 }, colorScheme });
    await show(page);
    await rest(page);
    await writeFile(`${folder}/${name}.webp`, await scaled(page, await page.screenshot(), 1200, "image/webp"));
    await context.close();
  }
}

await steps();
await film();
await looks();
await browser.close();
