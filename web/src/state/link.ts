import type { OakState, Vec3 } from "../protocol";
import { DEFAULT_DISPLAY, type Display, displayFrom } from "./display";
import { MAX_OAKS, type Moment, type Oak, type Rectangle, type StudioDocument, type Target, WHOLE_IMAGE } from "./document";

/** The state of the page in a link. */
export interface Linked {
  document: StudioDocument;
  display: Display;
}

/** Settings of the window rather than of what is shown: a link leaves them to the person who opens it. */
const LOCAL: (keyof Display)[] = ["theme", "split", "showStart", "showLeft", "showRight", "leftWidth", "rightWidth", "wipeAt"];

const VERSION = "v1.";

/** Writes the state as the fragment of an address. */
export function toFragment({ document, display }: Linked): string {
  const changed = Object.entries(display).filter(
    ([key, value]) => !LOCAL.includes(key as keyof Display) && value !== DEFAULT_DISPLAY[key as keyof Display],
  );
  const json = JSON.stringify({ document, display: Object.fromEntries(changed) });
  const binary = String.fromCharCode(...new TextEncoder().encode(json));
  return `#${VERSION}${btoa(binary).replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "")}`;
}

/** Reads a fragment; null if it is none of the page's. `local` are the settings that a link does not have. */
export function fromFragment(fragment: string, local: Display): Linked | null {
  const encoded = fragment.replace(/^#/, "");
  if (!encoded.startsWith(VERSION)) return null;
  try {
    const binary = atob(encoded.slice(VERSION.length).replaceAll("-", "+").replaceAll("_", "/"));
    const text = new TextDecoder().decode(Uint8Array.from(binary, (character) => character.charCodeAt(0)));
    return linkedFrom(JSON.parse(text) as Saved, local);
  } catch {
    return null;
  }
}

/** A state in a link or a session, of which nothing is known. */
interface Saved {
  document?: unknown;
  display?: unknown;
}

/** Checks a state; null if it is none. */
export function linkedFrom(json: Saved, local: Display): Linked | null {
  const document = documentFrom(json.document);
  if (!document) return null;
  const display = displayFrom(json.display);
  for (const key of LOCAL) Object.assign(display, { [key]: local[key] });
  return { document, display };
}

type Json = Record<string, unknown>;

function isObject(json: unknown): json is Json {
  return typeof json === "object" && json !== null && !Array.isArray(json);
}

function numbers(json: unknown, count: number): number[] | null {
  return Array.isArray(json) && json.length === count && json.every(Number.isFinite) ? (json as number[]) : null;
}

function documentFrom(json: unknown): StudioDocument | null {
  if (!isObject(json) || typeof json.scene !== "string" || !Array.isArray(json.oaks)) return null;
  const oaks = json.oaks.slice(0, MAX_OAKS).map(oakFrom).filter((oak) => oak !== null);
  const first = oaks[0];
  if (!first || new Set(oaks.map(({ key }) => key)).size !== oaks.length) return null;
  return {
    scene: json.scene,
    moment: momentFrom(json.moment),
    trajectory: typeof json.trajectory === "string" ? json.trajectory : null,
    motion: typeof json.motion === "string" ? json.motion : null,
    oaks,
    selected: oaks.find(({ key }) => key === json.selected)?.key ?? first.key,
    arePosesLinked: json.arePosesLinked !== false,
    region: (numbers(json.region, 4) as Rectangle | null) ?? WHOLE_IMAGE,
    target: targetFrom(json.target),
  };
}

function momentFrom(json: unknown): Moment | null {
  if (!isObject(json) || !isFrame(json.frame)) return null;
  return { frame: json.frame as number, time: Number.isFinite(json.time) ? (json.time as number) : null };
}

function isFrame(json: unknown): boolean {
  return Number.isSafeInteger(json) && (json as number) >= 0;
}

function targetFrom(json: unknown): Target | null {
  if (!isObject(json)) return null;
  if (typeof json.object === "string") return { object: json.object };
  const [minimum, maximum] = [numbers(json.minimum, 3), numbers(json.maximum, 3)];
  return minimum && maximum ? { minimum: minimum as Vec3, maximum: maximum as Vec3 } : null;
}

function oakFrom(json: unknown): Oak | null {
  if (!isObject(json) || typeof json.key !== "string") return null;
  const state = stateFrom(json.state);
  const mount = typeof json.mount === "string" ? { mount: json.mount } : {};
  return state && { key: json.key, isHidden: json.isHidden === true, state, ...mount };
}

/** Reads the state of an OAK; whether its names and numbers make sense is for the server to decide. */
function stateFrom(json: unknown): OakState | null {
  if (!isObject(json) || !isObject(json.pose) || typeof json.model !== "string") return null;
  const position = numbers(json.pose.position, 3);
  const quaternion = numbers(json.pose.quaternion, 4);
  if (!position || !quaternion) return null;
  const text = (value: unknown) => (typeof value === "string" ? value : null);
  const number = (value: unknown, fallback: number) => (Number.isFinite(value) ? (value as number) : fallback);
  const texts = (value: unknown) => {
    const entries = isObject(value) ? Object.entries(value).filter(([, one]) => text(one) !== null) : [];
    return Object.fromEntries(entries) as Record<string, string>;
  };
  return {
    model: json.model,
    calibration: text(json.calibration),
    pose: { position: position as Vec3, quaternion: quaternion as OakState["pose"]["quaternion"] },
    sensor: text(json.sensor) ?? "",
    lens: json.lens === "fisheye" ? "fisheye" : "pinhole",
    engine: text(json.engine) ?? "",
    preset: text(json.preset),
    filters: Array.isArray(json.filters) ? json.filters.filter((filter) => typeof filter === "string") : null,
    parameters: texts(json.parameters),
    extendedDisparity: json.extendedDisparity === true,
    seed: number(json.seed, 0),
    deviceSeed: Number.isFinite(json.deviceSeed) ? (json.deviceSeed as number) : null,
    populationSeed: Number.isFinite(json.populationSeed) ? (json.populationSeed as number) : null,
    drift: texts(json.drift),
    projector: number(json.projector, 1),
    ambient: number(json.ambient, 1),
    transparent: json.transparent === "through" ? "through" : "surface",
    colorImager: isObject(json.colorImager) ? texts(json.colorImager) : null,
    frame: isFrame(json.frame) ? (json.frame as number) : 0,
  };
}
