// Takes the pictures of the page: `npm run pictures -- FOLDER`, with the address of a server in OAKTWIN_STUDIO_URL. The manual's goes
// into the folder, and those that the tests compare into `test/looks`.
import { mkdir, writeFile } from "node:fs/promises";
import { record } from "./film.mjs";
import { FOLDER, LOOKS, openLook, small } from "./looks.mjs";
import { launch, open } from "./page.mjs";

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

await film();
await looks();
await browser.close();
