import assert from "node:assert/strict";
import { test } from "node:test";
import { load } from "./module.mjs";

const { decodeLz4, Lz4Error } = await load("net/lz4.ts");
const { FrameScheduler } = await load("net/scheduler.ts");
const { fromAngles, moved, rotate, toAngles } = await load("util/pose.ts");
const { formatFilter, parseFilter } = await load("state/filters.ts");
const { check, slider } = await load("state/parameters.ts");
const { History } = await load("state/history.ts");
const { fromFragment, toFragment } = await load("state/link.ts");
const { DEFAULT_DISPLAY } = await load("state/display.ts");
const { choosable } = await load("state/document.ts");
const { reflectances, reflecting } = await load("state/infrared.ts");
const { rank, sweep } = await load("studio/sweep.ts");

const text = (bytes) => new TextDecoder().decode(bytes);

test("LZ4 blocks of the format's description are decoded", () => {
  const block = (...parts) => Uint8Array.from(parts.flatMap((part) => (typeof part === "string" ? [...Buffer.from(part)] : part)));
  assert.equal(text(decodeLz4(block(0x50, "hello"), 5)), "hello");
  // Three literals, a copy of 9 that overlaps itself, and five last literals.
  assert.equal(text(decodeLz4(block(0x35, "abc", 3, 0, 0x50, "hello"), 17)), "abcabcabcabchello");
  // Lengths of 15 and more continue in further bytes: 15 + 255 + 10 literals, then a copy of 15 + 255 + 0 + 4.
  const literals = "x".repeat(280);
  const decoded = text(decodeLz4(block(0xff, 255, 10, literals, 1, 0, 255, 0, 0x10, "y"), 280 + 274 + 1));
  assert.equal(decoded, `${"x".repeat(554)}y`);
});

test("damaged LZ4 blocks are rejected", () => {
  for (const [block, length] of [[[0x50, 1], 5], [[0x10, 1, 9, 0], 5], [[0x10, 1, 0, 0], 5], [[0x10, 1], 2], [[0x10, 1, 1, 0], 3]]) {
    assert.throws(() => decodeLz4(Uint8Array.from(block), length), Lz4Error);
  }
});

test("at most two requests are in flight, and the newest of those that wait is sent", () => {
  const sent = [];
  const scheduler = new FrameScheduler((request) => sent.push(request));
  for (let region = 0; region < 5; region++) scheduler.request({ oak: "a", region });
  scheduler.request({ oak: "b", region: 9 });
  assert.deepEqual(sent.map(({ id, oak, region }) => [id, oak, region]), [[1, "a", 0], [2, "a", 1], [3, "b", 9]]);
  // The server answered the second and left out the first.
  assert.equal(scheduler.settle("a", 2).region, 1);
  assert.deepEqual(sent.at(-1), { type: "frame", id: 4, oak: "a", region: 4 });
  assert.equal(scheduler.isIdle, false);
  scheduler.settle("a", 4);
  scheduler.settle("b", 3);
  assert.equal(scheduler.isIdle, true);
  assert.equal(scheduler.settle("a", 1), null);
});

test("angles and quaternions agree for both up axes", () => {
  for (const up of ["y", "z"]) {
    const angles = { yaw: 30, pitch: -20, roll: 10 };
    const again = toAngles(fromAngles(angles, up), up);
    for (const key of Object.keys(angles)) assert.ok(Math.abs(again[key] - angles[key]) < 1e-9, `${up} ${key}`);
    const level = fromAngles({ yaw: 0, pitch: 90, roll: 0 }, up);
    const down = rotate(level, [1, 0, 0])[up === "z" ? 2 : 1];
    assert.ok(Math.abs(down + 1) < 1e-9, "a tilt of 90° looks down");
    const pose = { position: [0, 0, 0], quaternion: level };
    assert.ok(Math.abs(moved(pose, [0, 0, 2], up).position[up === "z" ? 2 : 1] - 2) < 1e-9, "up is up for a tilted OAK, too");
  }
});

test("filters are read and written as text", () => {
  for (const written of ["median", "spatial:alpha=0.5,delta=8"]) assert.equal(formatFilter(parseFilter(written)), written);
  assert.deepEqual(parseFilter("speckle:range=50"), { name: "speckle", parameters: { range: "50" } });
});

test("parameters are checked before they are sent", () => {
  const number = { type: "number", unit: "px", minimum: 0, maximum: 10, typical: null, step: null, choices: null };
  assert.deepEqual(check(number, " 2,5 "), { text: "2.5" });
  assert.deepEqual(check(number, "11"), { problem: "Enter 0 to 10 px." });
  assert.deepEqual(check({ ...number, type: "integer" }, "2.5"), { problem: "Enter a whole number." });
  assert.deepEqual(check({ ...number, minimum: -10 }, "-11"), { problem: "Enter −10 to 10 px." });
  assert.ok("problem" in check(number, ""));
  assert.deepEqual(check({ ...number, type: "string", choices: ["a", "b"] }, "c"), { problem: "Choose one of a, b." });
  const { from, to } = slider({ ...number, maximum: 100000 }, 0.1);
  assert.ok(from === 0 && to === 0.4, "a slider covers the useful part of a wide range");
  assert.equal(slider({ ...number, minimum: null, maximum: null }, 0), null);
  const odd = { ...number, type: "integer", minimum: 1, maximum: 63, typical: [1, 15], step: 2 };
  assert.deepEqual(slider(odd, 7), { from: 1, to: 15, step: 2 });
  assert.deepEqual(check(odd, "8"), { problem: "Enter 1, 3, … 63 px." });
  assert.deepEqual(check(odd, "9"), { text: "9" });
  assert.deepEqual(slider(odd, 21), { from: 1, to: 21, step: 2 }, "a default outside the usual range is reached");
});

test("reflectances are a part of a scene's id, before its posture or time", () => {
  const all = [["floor", 0.5], ["a;~@ =é/b", 0.25]];
  for (const state of ["", "~0.5,1.2", "@12.5"]) {
    const id = reflecting(`dropped-1;x=1${state}`, all);
    assert.equal(id, `dropped-1;floor=0.5;a%3B%7E%40%20%3D%C3%A9%2Fb=0.25${state}`);
    assert.deepEqual(reflectances(id), all);
    assert.equal(reflecting(id, []), `dropped-1${state}`);
  }
  assert.deepEqual(reflectances("first"), []);
  assert.deepEqual(reflectances("first;%zz=1"), [["%zz", 1]]);
});

test("a gesture is one step of undo", () => {
  const history = new History(0);
  for (let i = 1; i <= 5; i++) history.commit("drag", () => i);
  history.commit("other", () => 9);
  history.undo();
  assert.equal(history.get(), 5);
  history.undo();
  assert.equal(history.get(), 0);
  history.redo();
  assert.equal(history.get(), 5);
  assert.equal(history.canRedo, true);
});

const state = {
  model: "OAK-D", calibration: null, pose: { position: [1, 2, 3], quaternion: [0, 0, 0, 1] }, sensor: "depth_stereo", lens: "pinhole",
  engine: "stereo-noise", preset: null, filters: ["median"], parameters: { bias: "0.1" }, extendedDisparity: true, seed: 3,
  deviceSeed: 4, populationSeed: 5, drift: { yaw: "0.3" }, projector: 0.5, ambient: 0, transparent: "through",
  colorImager: { light: "0.5" }, frame: 3,
};

test("a link restores the state, and links with other content are ignored", () => {
  const document = {
    scene: "demo", moment: null, trajectory: null, motion: "dropped-list", oaks: [{ key: "oak1", isHidden: false, mount: "hand", state }], selected: "oak1", arePosesLinked: false,
    region: [0, 0, 0.5, 1], target: { object: "/Größe/日本" },
  };
  const display = { ...DEFAULT_DISPLAY, depthMap: "turbo", panels: ["error"] };
  assert.deepEqual(fromFragment(toFragment({ document, display }), DEFAULT_DISPLAY), { document, display });
  for (const fragment of ["", "#v1.", "#v1.!!", "#v2.e30", "#v1.e30", `#v1.${btoa('{"document":{"scene":"a","oaks":[{}]}}')}`]) {
    assert.equal(fromFragment(fragment, DEFAULT_DISPLAY), null, fragment);
  }
});

test("a sweep tries all heights and tilts, and ranks them", () => {
  const tried = sweep([{ key: "oak2", state }], { from: 1, to: 2, count: 2 }, { from: 0, to: 30, count: 3 }, "z");
  assert.deepEqual(tried.map(({ state: { pose } }) => [pose.position[2], Math.round(toAngles(pose.quaternion, "z").pitch)]), [
    [1, 0], [1, 15], [1, 30], [2, 0], [2, 15], [2, 30],
  ]);
  const poses = [0.1, 0.5, 0.5, 0.2, 0, 0].map((measured, i) => ({ seen: 1, measured, medianAbsoluteErrorM: 0.1 / (i + 1), lost: {} }));
  const ranked = rank(tried, poses, "z");
  assert.deepEqual(ranked.slice(0, 3).map(({ heightM, tiltDeg }) => [heightM, Math.round(tiltDeg)]), [[1, 30], [1, 15], [2, 0]]);
  assert.ok(ranked.every(({ key }) => key === "oak2"), "each pose belongs to its OAK");
});

test("what contains several objects can be chosen, too", () => {
  const paths = ["/Room/Table/Leg", "/Room/Table/Top", "/Room/Lamp/Shade", "/Door"];
  assert.deepEqual(choosable(paths), ["/Door", "/Room", "/Room/Lamp/Shade", "/Room/Table", "/Room/Table/Leg", "/Room/Table/Top"]);
});
