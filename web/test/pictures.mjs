// Takes the manual's picture of the page: `npm run pictures -- FOLDER`, with the address of a server in OAKTWIN_STUDIO_URL.
import { launch, open, rest } from "./page.mjs";

const [, , folder = "."] = process.argv;
const browser = await launch();
const { page } = await open(browser, { viewport: { width: 1440, height: 900 }, colorScheme: "dark" });
await page.getByTestId("show-reason").click();
await rest(page);
const panel = await page.locator('[data-testid$="-sensor"] canvas').boundingBox();
await page.mouse.move(panel.x + panel.width * 0.28, panel.y + panel.height * 0.72);
await page.waitForTimeout(500);
await rest(page);
await page.screenshot({ path: `${folder}/studio.png` });
await browser.close();
