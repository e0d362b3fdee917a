import { api } from "../net/api";
import { decodeFrame, type Frame } from "../net/wire";
import type { FrameRequest, ImageName, OakState, PoseCoverage, ServerMessage } from "../protocol";
import { findEngine, findModel, findSensor, type Target, sceneAt } from "../state/document";
import { fit } from "./frames";
import type { Shown, Studio } from "./studio";

/** The light of a row: the brightness of the scene's own. */
export const LIGHTS = [{ name: "day", ambient: 1 }, { name: "night", ambient: 0 }] as const;

/** The largest images of a report. */
const SIZE: [number, number] = [640, 400];
const IMAGES: ImageName[] = ["color", "depth", "reference", "sensor"];

/** One OAK in one light. */
export interface Row {
  oak: string;
  light: (typeof LIGHTS)[number]["name"];
  state: OakState;
  coverage: PoseCoverage;
  frame: Shown;
}

export interface Report {
  scene: string;
  region: Target;
  toleranceMm: number | null;
  rows: Row[];
}

/** Returns the state of an OAK in a light, measured by the matcher if its sensor is a stereo pair. */
export function stateFor(studio: Studio, state: OakState, ambient: number): OakState {
  const catalog = studio.catalog.get();
  const sensor = findSensor(catalog, state);
  const matcher = sensor?.engines.find((name) => findEngine(catalog, { ...state, engine: name })?.isMatcher);
  const engine = matcher ?? state.engine;
  const projector = findModel(catalog, state.model)?.hasProjector ? Math.max(state.projector, Number(ambient === 0)) : 0;
  return { ...state, engine, parameters: engine === state.engine ? state.parameters : {}, ambient, projector };
}

/** Measures every OAK that is shown by day and by night. `onRow` is called after each. */
export async function makeReport(studio: Studio, region: Target, toleranceMm: number | null, signal: AbortSignal, onRow: (done: number, of: number) => void): Promise<Report> {
  const document = studio.document.get();
  const { oaks } = document;
  const scene = sceneAt(document);
  const shown = oaks.filter((oak) => !oak.isHidden && studio.hasDepth(oak.state));
  const rows: Row[] = [];
  const of = shown.length * LIGHTS.length;
  for (const oak of shown) {
    for (const { name, ambient } of LIGHTS) {
      onRow(rows.length, of);
      const state = stateFor(studio, oak.state, ambient);
      const answer = await api.coverage({ scene, states: [state], region, toleranceMm }, signal);
      const resolution = findSensor(studio.catalog.get(), state)?.resolution ?? SIZE;
      const frame = await oneFrame({ oak: "report", scene, state, size: fit(resolution, SIZE), images: IMAGES, region: [0, 0, 1, 1] }, signal);
      rows.push({
        oak: oak.key, light: name, state, coverage: answer.together,
        frame: { ...frame, state, scene, requested: IMAGES, isPreview: false },
      });
    }
  }
  return { scene: studio.scene.get()?.name ?? "", region, toleranceMm, rows };
}

/** Asks for one frame on a connection of its own. */
function oneFrame(request: Omit<FrameRequest, "type" | "id">, signal: AbortSignal): Promise<Frame> {
  return new Promise((resolve, reject) => {
    const socket = new WebSocket(`${location.protocol === "https:" ? "wss:" : "ws:"}//${location.host}/api/live`);
    const fail = (error: Error) => {
      socket.close();
      reject(error);
    };
    signal.addEventListener("abort", () => fail(new Error("The report was cancelled.")));
    socket.binaryType = "arraybuffer";
    socket.onopen = () => socket.send(JSON.stringify({ type: "frame", id: 1, ...request }));
    socket.onerror = () => fail(new Error("The connection to the server failed; make the report again."));
    socket.onmessage = ({ data }: MessageEvent<string | ArrayBuffer>) => {
      if (typeof data === "string") {
        const message = JSON.parse(data) as ServerMessage;
        return fail(new Error(message.type === "error" ? message.error : "The server gave another answer."));
      }
      socket.close();
      resolve(decodeFrame(data, () => undefined));
    };
  });
}

const COLUMNS = [
  "model", "engine", "light", "ambient", "projector", "x_m", "y_m", "z_m", "qx", "qy", "qz", "qw", "tolerance_mm", "seen", "measured",
  "median_absolute_error_mm",
];

/** Writes a report as a table, a row for each OAK and light, with a column for each reason that occurs. */
export function reportCsv({ rows, toleranceMm }: Report): string {
  const reasons = [...new Set(rows.flatMap(({ coverage }) => Object.keys(coverage.lost)))].sort();
  const cell = (value: string | number | null) => {
    const text = value === null ? "" : String(value);
    return /[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
  };
  const lines = rows.map(({ state, light, coverage }) => [
    state.model, state.engine, light, state.ambient, state.projector, ...state.pose.position, ...state.pose.quaternion, toleranceMm, coverage.seen, coverage.measured,
    coverage.medianAbsoluteErrorM === null ? null : coverage.medianAbsoluteErrorM * 1000, ...reasons.map((name) => coverage.lost[name] ?? 0),
  ]);
  return [[...COLUMNS, ...reasons], ...lines].map((line) => `${line.map(cell).join(",")}\n`).join("");
}
