import type {
  AccuracyCurve, CalibrationInfo, Catalog, CoverageAnswer, CoverageRequest, ExportRequest, Failure, Finding, MotionAnswer, MotionInfo, MotionLine, MotionRequest, OakState, SaveRequest, SceneInfo,
  SessionInfo, SurfaceRequest, TrajectoryInfo,
} from "../protocol";
import type { Units } from "../state/units";
import { decodeTextured, type Textured } from "./textured";
import { decodeMesh, type Mesh } from "./wire";

/** An answer of the server that is an error. */
export class ApiError extends Error {
  constructor(readonly failure: Failure, readonly status: number) {
    super(failure.error);
  }

  get findings(): Finding[] {
    return this.failure.findings ?? [];
  }
}

export interface Exported {
  name: string;
  file: Blob;
  findings: Finding[];
}

async function request(path: string, init?: RequestInit): Promise<Response> {
  const response = await fetch(path, init);
  if (response.ok) return response;
  const text = await response.text();
  throw new ApiError(failure(text, response), response.status);
}

/** Reads a failure; a body that is none comes from something other than the studio, such as a proxy. */
function failure(text: string, response: Response): Failure {
  try {
    const parsed = JSON.parse(text) as Failure;
    if (typeof parsed.error === "string") return parsed;
  } catch {
    // Not JSON.
  }
  return { error: text.trim() || `The server answered ${response.status} ${response.statusText}.`, field: null };
}

async function json<T>(path: string, init?: RequestInit): Promise<T> {
  return (await (await request(path, init)).json()) as T;
}

function posted(body: unknown, signal?: AbortSignal): RequestInit {
  const init: RequestInit = { method: "POST", headers: { "Content-Type": "application/json" }, body: JSON.stringify(body) };
  if (signal) init.signal = signal;
  return init;
}

/** The lines of an answer, as they come. */
async function* lines(response: Response): AsyncGenerator<string> {
  const reader = response.body?.pipeThrough(new TextDecoderStream()).getReader();
  let rest = "";
  for (;;) {
    const part = await reader?.read();
    if (!part || part.done) break;
    const complete = (rest + part.value).split("\n");
    rest = complete.pop() ?? "";
    yield* complete;
  }
}

/** Asks for a file. */
async function saved(path: string, body: unknown, otherName: string): Promise<Exported> {
  const response = await request(path, posted(body));
  const disposition = response.headers.get("Content-Disposition") ?? "";
  const name = /filename="([^"]+)"/.exec(disposition)?.[1] ?? otherName;
  const findings = JSON.parse(response.headers.get("X-Findings") ?? "[]") as Finding[];
  return { name, file: await response.blob(), findings };
}

export const api = {
  catalog: () => json<Catalog>("/api/catalog"),

  scene: (id: string) => json<SceneInfo>(`/api/scenes/${encodeURIComponent(id)}`),

  async sceneMesh(id: string, triangles: number): Promise<Mesh> {
    const response = await request(`/api/scenes/${encodeURIComponent(id)}/mesh?triangles=${triangles}`);
    return decodeMesh(await response.arrayBuffer());
  },

  async sceneTextures(id: string): Promise<Textured> {
    const response = await request(`/api/scenes/${encodeURIComponent(id)}/textures`);
    return decodeTextured(await response.arrayBuffer());
  },

  async body(model: string): Promise<Mesh> {
    const response = await request(`/api/models/${encodeURIComponent(model)}/body`);
    return decodeMesh(await response.arrayBuffer());
  },

  openScene(file: File, units?: Units): Promise<SceneInfo> {
    const query = new URLSearchParams({ name: file.name, ...(units && { scale: String(units.scale), up: units.up }) });
    return json<SceneInfo>(`/api/scenes?${query}`, { method: "POST", body: file });
  },

  openRobot: (file: File, scene: string) =>
    json<SceneInfo>(`/api/robots?${new URLSearchParams({ name: file.name, scene })}`, { method: "POST", body: file }),

  openCalibration: (file: File) =>
    json<CalibrationInfo>(`/api/calibrations?name=${encodeURIComponent(file.name)}`, { method: "POST", body: file }),

  openTrajectory: (file: File) =>
    json<TrajectoryInfo>(`/api/trajectories?name=${encodeURIComponent(file.name)}`, { method: "POST", body: file }),

  trajectory: (id: string) => json<TrajectoryInfo>(`/api/trajectories/${encodeURIComponent(id)}`),

  openMotion: (file: File, scene: string) =>
    json<MotionInfo>(`/api/motions?${new URLSearchParams({ name: file.name, scene })}`, { method: "POST", body: file }),

  motion: (id: string) => json<MotionInfo>(`/api/motions/${encodeURIComponent(id)}`),

  /** Measures the coverage over a motion. `onProgress` is called with the number of postures that are done. */
  async motionCoverage(body: MotionRequest, signal: AbortSignal, onProgress: (done: number, of: number) => void): Promise<MotionAnswer> {
    const response = await request("/api/motions/coverage", posted(body, signal));
    for await (const text of lines(response)) {
      const line = JSON.parse(text) as MotionLine;
      if (line.type === "answer") return line;
      if (line.type === "error") throw new ApiError(line, response.status);
      onProgress(line.done, line.total);
    }
    throw new Error("The server ended before the result was complete; start it again, and measure again.");
  },

  motionCommand: (body: MotionRequest) => saved("/api/motions/command", body, "coverage.sh"),

  openSession: (file: File) =>
    json<SessionInfo>(`/api/session/open?name=${encodeURIComponent(file.name)}`, { method: "POST", body: file }),

  saveSession: (body: SaveRequest) => saved("/api/session/save", body, "session.oaktwin"),

  accuracy: (state: OakState, signal: AbortSignal) => json<AccuracyCurve>("/api/accuracy", posted(state, signal)),

  coverage: (body: CoverageRequest, signal: AbortSignal) => json<CoverageAnswer>("/api/coverage", posted(body, signal)),

  async surface(body: SurfaceRequest, signal: AbortSignal): Promise<Mesh> {
    const response = await request("/api/coverage/surface", posted(body, signal));
    return decodeMesh(await response.arrayBuffer());
  },

  /** Returns a file with its name, and what its format cannot represent. */
  export: (body: ExportRequest) => saved("/api/export", body, `oaktwin-${body.what}`),
};
