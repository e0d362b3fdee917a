import type { Catalog, DepthSensor, Engine, Model, OakState, Pose, Vec3 } from "../protocol";

/** One of the OAKs on the page. */
export interface Oak {
  /** Identifies it on the page and in messages. */
  key: string;
  /** Whether it is neither drawn nor measured. */
  isHidden: boolean;
  state: OakState;
  /** The link of the scene's robot that carries it. */
  mount?: string | null;
}

/** A rectangle as fractions of the image: left, top, right, bottom. */
export type Rectangle = [number, number, number, number];

/** The part of the scene whose coverage is computed. */
export type Target = { minimum: Vec3; maximum: Vec3 } | { object: string };

/** A frame of the timeline. */
export interface Moment {
  frame: number;
  /** The time code of an animated scene; null if only OAKs move. */
  time: number | null;
}

/** Everything that undo and a link restore. */
export interface StudioDocument {
  scene: string;
  /** Null for the scene as its file was opened. */
  moment: Moment | null;
  /** The id of the trajectory along which OAKs move. */
  trajectory: string | null;
  /** The id of the list of postures of the scene's robot. */
  motion: string | null;
  oaks: Oak[];
  /** The key of the OAK that the controls change. */
  selected: string;
  /** Whether moving one OAK moves all. */
  arePosesLinked: boolean;
  /** The rectangle of the images for statistics. */
  region: Rectangle;
  target: Target | null;
}

/** Returns the objects that can be chosen, by path: those of the scene, and what has several of them below it. */
export function choosable(paths: readonly string[]): string[] {
  const below = new Map<string, number>();
  for (const path of paths) {
    for (let end = path.lastIndexOf("/"); end > 0; end = path.lastIndexOf("/", end - 1)) {
      const parent = path.slice(0, end);
      below.set(parent, (below.get(parent) ?? 0) + 1);
    }
  }
  const groups = [...below].filter(([, count]) => count > 1).map(([path]) => path);
  return [...new Set([...paths, ...groups])].sort();
}

export const WHOLE_IMAGE: Rectangle = [0, 0, 1, 1];

/** More would neither fit on the page nor be measured in time. */
export const MAX_OAKS = 6;

export function findModel(catalog: Catalog, name: string): Model | undefined {
  return catalog.models.find((model) => model.name === name);
}

export function findSensor(catalog: Catalog, state: OakState): DepthSensor | undefined {
  return findModel(catalog, state.model)?.depthSensors.find((sensor) => sensor.id === state.sensor);
}

export function findEngine(catalog: Catalog, state: OakState): Engine | undefined {
  return catalog.engines.find((engine) => engine.name === state.engine);
}

/** Returns the state of a model with its defaults. */
export function defaultState(model: Model, pose: Pose): OakState {
  const sensor = model.depthSensors[0];
  return {
    model: model.name,
    calibration: null,
    pose,
    sensor: sensor?.id ?? "",
    lens: "pinhole",
    engine: sensor?.engines[0] ?? "",
    preset: null,
    filters: null,
    parameters: {},
    extendedDisparity: false,
    seed: 0,
    deviceSeed: null,
    populationSeed: null,
    drift: {},
    projector: model.hasProjector ? 1 : 0,
    ambient: 1,
    transparent: "surface",
    colorImager: null,
    frame: 0,
  };
}

/** Returns the state of another model that keeps what does not depend on the model. */
export function withModel(state: OakState, model: Model): OakState {
  const { pose, seed, deviceSeed, populationSeed, ambient, transparent, colorImager, frame } = state;
  const next = { ...defaultState(model, pose), seed, deviceSeed, populationSeed, ambient, transparent, colorImager, frame };
  const sensor = model.depthSensors.find(({ id }) => id === state.sensor);
  if (!sensor) return next;
  const drift = sensor.kind === "stereo" ? state.drift : {};
  const engine = sensor.engines.includes(state.engine) ? state.engine : next.engine;
  const preset = state.preset !== null && sensor.presets.includes(state.preset) ? state.preset : null;
  const parameters = engine === state.engine ? state.parameters : {};
  return { ...next, sensor: sensor.id, engine, preset, parameters, drift, filters: state.filters, extendedDisparity: state.extendedDisparity };
}

/** Returns a key that no OAK has. */
export function freeKey(oaks: Oak[]): string {
  let number = 1;
  while (oaks.some((oak) => oak.key === `oak${number}`)) number++;
  return `oak${number}`;
}

export function newDocument(catalog: Catalog, scene: string, pose: Pose): StudioDocument {
  const model = findModel(catalog, catalog.model) ?? catalog.models[0];
  const oaks = model ? [{ key: "oak1", isHidden: false, state: defaultState(model, pose) }] : [];
  return { scene, moment: null, trajectory: null, motion: null, oaks, selected: "oak1", arePosesLinked: true, region: WHOLE_IMAGE, target: null };
}

/** Returns a document that shows another scene as it was opened. */
export function withScene(document: StudioDocument, scene: string): StudioDocument {
  return { ...document, scene, moment: null, trajectory: null, motion: null, target: null };
}

/** Returns the scene of requests: at the time of the document, if the scene is animated. */
export function sceneAt({ scene, moment }: StudioDocument): string {
  return moment === null || moment.time === null ? scene : `${scene}@${moment.time}`;
}

export function selectedOak(document: StudioDocument): Oak | undefined {
  return document.oaks.find((oak) => oak.key === document.selected);
}

/** Changes one OAK; a change of the pose moves all OAKs if their poses are linked. */
export function changeOak(document: StudioDocument, key: string, change: (state: OakState) => OakState): StudioDocument {
  const before = document.oaks.find((oak) => oak.key === key);
  if (!before) return document;
  const changed = change(before.state);
  // An OAK that leaves its trajectory takes frames on its own.
  const state = changed.pose === before.state.pose ? changed : { ...changed, frame: 0 };
  const oaks = document.oaks.map((oak) => {
    if (oak.key === key) return { ...oak, state };
    if (document.arePosesLinked && state.pose !== before.state.pose) return { ...oak, state: { ...oak.state, pose: state.pose, frame: 0 } };
    return oak;
  });
  return { ...document, oaks };
}

/** Adds an OAK after the selected one and selects it. */
export function addOak(document: StudioDocument, state: OakState): StudioDocument {
  if (document.oaks.length >= MAX_OAKS) return document;
  const oak = { key: freeKey(document.oaks), isHidden: false, state };
  const place = document.oaks.findIndex(({ key }) => key === document.selected) + 1;
  return { ...document, oaks: document.oaks.toSpliced(place, 0, oak), selected: oak.key };
}

export function removeOak(document: StudioDocument, key: string): StudioDocument {
  if (document.oaks.length <= 1) return document;
  const place = document.oaks.findIndex((oak) => oak.key === key);
  const oaks = document.oaks.filter((oak) => oak.key !== key);
  const neighbour = oaks[Math.min(place, oaks.length - 1)];
  return { ...document, oaks, selected: document.selected === key ? (neighbour?.key ?? "") : document.selected };
}
