import { api } from "../net/api";
import type { Mesh } from "../net/wire";
import { type Oak, selectedOak, sceneAt } from "../state/document";
import { Store } from "../util/store";
import type { Studio } from "./studio";

/** How long nothing must have changed before a surface is painted anew, ms. */
const DELAY = 400;

/** What the selected OAK measures of the region's surface. */
export interface Painted {
  mesh: Mesh | null;
  /** Why there is none. */
  error: string | null;
}

const NOTHING: Painted = { mesh: null, error: null };

/** Keeps the painted surface of the region up to date. */
export class Painting extends Store<Painted> {
  private wanted: readonly unknown[] = [];
  private running: AbortController | null = null;
  private timer = 0;

  constructor(private readonly studio: Studio) {
    super(NOTHING);
    for (const store of [studio.document, studio.display, studio.connection, studio.scene]) store.subscribe(() => this.follow());
    this.follow();
  }

  /** Whether the surface is that of the current state. */
  get isIdle(): boolean {
    return this.timer === 0 && this.running === null;
  }

  private follow(): void {
    const { document, display, connection, scene } = this.studio;
    const { target, scene: id } = document.get();
    const oak = selectedOak(document.get());
    const isOn = display.get().paintsCoverage && target !== null && oak !== undefined && this.studio.hasDepth(oak.state) && scene.get()?.id === id;
    const wanted = isOn && connection.get() === "open" ? [sceneAt(document.get()), target, oak.state] : [];
    if (wanted.length === this.wanted.length && wanted.every((part, i) => part === this.wanted[i])) return;
    this.wanted = wanted;
    this.running?.abort();
    this.running = null;
    clearTimeout(this.timer);
    this.timer = 0;
    if (oak && wanted.length) this.timer = window.setTimeout(() => void this.paint(oak), DELAY);
    else this.set(NOTHING);
  }

  private async paint(oak: Oak): Promise<void> {
    this.timer = 0;
    const document = this.studio.document.get();
    const { target } = document;
    if (!target) return;
    const running = new AbortController();
    this.running = running;
    try {
      const mesh = await api.surface({ scene: sceneAt(document), state: oak.state, region: target }, running.signal);
      if (this.running === running) this.set({ mesh, error: null });
    } catch (error) {
      if (this.running === running) this.set({ mesh: null, error: error instanceof Error ? error.message : String(error) });
    } finally {
      if (this.running === running) this.running = null;
    }
  }
}
