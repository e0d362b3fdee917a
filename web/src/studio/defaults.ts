import type { OakState, Parameter } from "../protocol";
import { Store } from "../util/store";

/** What the defaults of an engine's parameters depend on. */
function keyOf({ model, calibration, populationSeed, sensor, lens, engine, preset, extendedDisparity, drift }: OakState): string {
  return JSON.stringify([model, calibration, populationSeed, sensor, lens, engine, preset, extendedDisparity, drift]);
}

/**
 * The effective defaults of parameters. They depend on the model and the preset, and the server reports effective values only: those
 * of parameters that were not changed are the defaults.
 */
export class Defaults extends Store<ReadonlyMap<string, Readonly<Record<string, string>>>> {
  constructor() {
    super(new Map());
  }

  learn(state: OakState, effective: Record<string, string>): void {
    const known = this.get().get(keyOf(state)) ?? {};
    const news = Object.entries(effective).filter(([name, value]) => !(name in state.parameters) && known[name] !== value);
    if (news.length) this.set(new Map(this.get()).set(keyOf(state), { ...known, ...Object.fromEntries(news) }));
  }

  of(state: OakState, parameter: Parameter): string {
    return this.get().get(keyOf(state))?.[parameter.name] ?? parameter.default;
  }
}
