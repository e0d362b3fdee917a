// The surfaces of the 3D view.
import assert from "node:assert/strict";
import { after as afterAll, before, test } from "node:test";
import { read } from "./image.mjs";
import { launch, open, rest, skip } from "./page.mjs";

let browser;
before(async () => {
  if (!skip) browser = await launch();
});
afterAll(() => browser?.close());

/** The number of different colours of a picture of the 3D view. */
async function colours(page) {
  const { data } = await read(page, await page.getByTestId("view").screenshot());
  const seen = new Set();
  for (let at = 0; at < data.length; at += 4) seen.add((data[at] << 16) | (data[at + 1] << 8) | data[at + 2]);
  return seen.size;
}

test("surfaces have their textures, and mean colours without them", { skip }, async () => {
  const plain = await open(browser, { opened: async (page) => page.route("**/textures", (route) => route.fulfill({ status: 422, body: '{"error": "none"}' })) });
  await plain.page.evaluate(() => window.studio.document.commit("test", (document) => document));
  const textured = await open(browser);
  await rest(textured.page);
  const answer = await textured.page.evaluate(async () => {
    const bytes = await (await fetch("/api/scenes/first/textures")).arrayBuffer();
    const length = new DataView(bytes).getUint32(0, true);
    return JSON.parse(new TextDecoder().decode(new Uint8Array(bytes, 4, length)));
  });
  assert.ok(answer.groups.length > 3 && answer.textures.length > 3, JSON.stringify(answer));
  assert.ok(answer.textures.every(({ width, height }) => Math.max(width, height) <= 512));
  assert.ok((await colours(textured.page)) > 1.5 * (await colours(plain.page)));
  assert.deepEqual(textured.errors, []);
  await plain.context.close();
  await textured.context.close();
});
