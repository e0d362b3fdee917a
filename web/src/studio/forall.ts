import { findModel, findSensor } from "../state/document";
import type { Catalog, OakState } from "../protocol";
import type { Studio } from "./studio";

/** What can be set for all OAKs at once. */
export const SHARED = [
  { name: "engine", title: "Engine for all" },
  { name: "light", title: "Light for all" },
  { name: "preset", title: "Preset for all" },
] as const;

export type Shared = (typeof SHARED)[number]["name"];

/** Gives all OAKs what the selected one has; says which ones cannot have it. */
export function setForAll(studio: Studio, shared: Shared): void {
  const document = studio.document.get();
  const selected = document.oaks.find(({ key }) => key === document.selected);
  if (!selected) return;
  const catalog = studio.catalog.get();
  const changed = document.oaks.map((oak) => ({ oak, state: withShared(oak.state, selected.state, shared, catalog) }));
  studio.document.commit(`${shared} for all`, (document) => ({
    ...document,
    oaks: changed.map(({ oak, state }) => (state && state !== oak.state ? { ...oak, state } : oak)),
  }));
  const left = changed.filter(({ state }) => state === null).map(({ oak }) => oak.state.model);
  const name = shared === "engine" ? `engine ${selected.state.engine}` : shared === "preset" ? `preset ${selected.state.preset ?? "none"}` : "light";
  if (left.length) studio.notify("warning", `The ${name} does not exist for ${left.join(", ")}, which ${left.length === 1 ? "keeps its own" : "keep their own"}.`);
  else studio.notify("note", `All OAKs have the ${name}.`);
}

/** Returns a state with what another one has; null if its sensor cannot have it. */
function withShared(state: OakState, from: OakState, shared: Shared, catalog: Catalog): OakState | null {
  const sensor = findSensor(catalog, state);
  if (!sensor) return null;
  switch (shared) {
    case "engine":
      if (!sensor.engines.includes(from.engine)) return null;
      return state.engine === from.engine ? state : { ...state, engine: from.engine, parameters: {} };
    case "preset":
      return from.preset === null || sensor.presets.includes(from.preset) ? { ...state, preset: from.preset } : null;
    case "light": {
      if (sensor.kind !== "stereo") return null;
      const hasProjector = findModel(catalog, state.model)?.hasProjector ?? false;
      return { ...state, ambient: from.ambient, projector: hasProjector ? from.projector : 0 };
    }
  }
}
