import { api } from "../net/api";
import type { AccuracyCurve, OakState } from "../protocol";
import { Store } from "../util/store";
import type { Studio } from "./studio";

/** How long an OAK must not change before its curve is measured, ms. */
const DELAY = 350;

/** The part of a state that the curve depends on: not on where the OAK is. */
function keyOf(state: OakState): string {
  return JSON.stringify({ ...state, pose: null });
}

export interface Measured {
  key: string;
  curve: AccuracyCurve | null;
  error: string | null;
}

/** Keeps the accuracy curves of all OAKs up to date, one request at a time, while `isWanted`. */
export class AccuracyCurves extends Store<ReadonlyMap<string, Measured>> {
  private timer = 0;
  private running: AbortController | null = null;
  private isWanted = false;

  constructor(private readonly studio: Studio) {
    super(new Map());
    studio.document.subscribe(() => this.later());
    studio.connection.subscribe(() => this.later());
  }

  /** Starts or stops following, because the chart is shown or hidden. */
  want(isWanted: boolean): void {
    this.isWanted = isWanted;
    this.later();
  }

  private later(): void {
    clearTimeout(this.timer);
    this.timer = window.setTimeout(() => void this.follow(), DELAY);
  }

  private async follow(): Promise<void> {
    this.running?.abort();
    const { studio } = this;
    const oaks = studio.document.get().oaks.filter((oak) => !oak.isHidden && studio.hasDepth(oak.state));
    if (!this.isWanted || studio.connection.get() !== "open") return;
    const running = new AbortController();
    this.running = running;
    const before = this.get();
    if ([...before.keys()].some((key) => !oaks.some((oak) => oak.key === key))) {
      this.set(new Map([...before].filter(([key]) => oaks.some((oak) => oak.key === key))));
    }
    for (const oak of oaks) {
      const key = keyOf(oak.state);
      if (this.get().get(oak.key)?.key === key) continue;
      const measured = await this.measure(key, oak.state, running.signal);
      if (running.signal.aborted) return;
      this.set(new Map(this.get()).set(oak.key, measured));
    }
  }

  private async measure(key: string, state: OakState, signal: AbortSignal): Promise<Measured> {
    try {
      return { key, curve: await api.accuracy(state, signal), error: null };
    } catch (error) {
      return { key, curve: null, error: error instanceof Error ? error.message : String(error) };
    }
  }
}
