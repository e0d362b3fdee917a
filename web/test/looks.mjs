// The pages whose looks are compared with pictures that were committed.
import { open, rest } from "./page.mjs";
import { read, scaled } from "./image.mjs";

/** The width of the committed pictures: text is a texture in them, so that other fonts change little. */
const WIDTH = 288;

export const LOOKS = [
  { name: "first-light", viewport: { width: 1440, height: 900 }, colorScheme: "light", show: async () => {} },
  {
    name: "place-dark",
    viewport: { width: 1152, height: 768 },
    colorScheme: "dark",
    show: async (page) => {
      await page.getByTestId("tab-place").click();
      await page.getByTestId("target").selectOption("/Room/Table/Top");
      await page.locator('[data-testid="coverage"] table').waitFor();
      await rest(page);
    },
  },
];

/** The folder of the committed pictures. */
export const FOLDER = new URL("looks/", import.meta.url).pathname;

/** Opens the page as a look shows it. */
export async function openLook(browser, { viewport, colorScheme, show }) {
  const opened = await open(browser, { viewport, colorScheme, fullSize: "large" });
  await show(opened.page);
  return opened;
}

export async function small(page) {
  return scaled(page, await page.screenshot(), WIDTH);
}

/** The pixels of what the page shows, and of a committed picture. */
export async function pair(page, committed) {
  return Promise.all([small(page).then((png) => read(page, png)), read(page, committed)]);
}
