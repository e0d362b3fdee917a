import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { after as afterAll, before, test } from "node:test";
import { difference } from "./image.mjs";
import { FOLDER, LOOKS, openLook, pair } from "./looks.mjs";
import { launch, rest, skip } from "./page.mjs";

/** Other fonts change less than this; a changed layout changes more. The second number is the share of pixels that differ by FAR. */
const MEAN = 4;
const SHARE = 0.02;
const FAR = 40;

/** What must not matter, and what must be noticed. */
const FONTS = "body { font-family: 'DejaVu Serif', serif !important; }";
const CHANGES = [
  ".page { grid-template-columns: 26rem minmax(0, 1fr) 22rem !important; }",
  ".legend { display: none !important; }",
  ".panel canvas { visibility: hidden !important; }",
  ":root { --panel: #808080 !important; }",
];

let browser;
before(async () => {
  if (!skip) browser = await launch();
});
afterAll(() => browser?.close());

const isSame = ({ mean, share }) => mean <= MEAN && share <= SHARE;
const words = ({ mean, share }) => `mean ${mean.toFixed(2)}, ${(share * 100).toFixed(2)} % far`;

for (const look of LOOKS) {
  test(`the page looks as in ${look.name}.png`, { skip }, async () => {
    const committed = await readFile(`${FOLDER}${look.name}.png`);
    const { page, context } = await openLook(browser, look);
    const found = difference(...(await pair(page, committed)), FAR);
    assert.ok(isSame(found), `${words(found)}; look at it, and run cargo xtask web --pictures if it is as it should be`);
    await context.close();
  });
}

test("other fonts do not matter to the comparison, and a changed style does", { skip }, async () => {
  const [look] = LOOKS;
  const committed = await readFile(`${FOLDER}${look.name}.png`);
  const { page, context } = await openLook(browser, look);
  const differs = async (content) => {
    const style = await page.evaluateHandle((content) => {
      const sheet = new CSSStyleSheet();
      sheet.replaceSync(content);
      document.adoptedStyleSheets = [sheet];
    }, content);
    await style.dispose();
    await page.waitForTimeout(300);
    await rest(page);
    return difference(...(await pair(page, committed)), FAR);
  };
  const fonts = await differs(FONTS);
  assert.ok(isSame(fonts), `fonts: ${words(fonts)}`);
  for (const change of CHANGES) {
    const found = await differs(change);
    assert.ok(!isSame(found), `${change} is not noticed: ${words(found)}`);
  }
  await context.close();
});
