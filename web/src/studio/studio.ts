import { api, ApiError } from "../net/api";
import type { Connection } from "../net/live";
import type { Frame } from "../net/wire";
import type { CalibrationInfo, Catalog, Finding, ImageName, OakState, ProbeAnswer, Rejection, SceneInfo } from "../protocol";
import { type Display, loadDisplay, saveDisplay, type Side } from "../state/display";
import { changeOak, findModel, newDocument, type StudioDocument, withScene } from "../state/document";
import { History } from "../state/history";
import { fromFragment, toFragment } from "../state/link";
import type { Asked } from "./files";
import { Motion } from "./motion";
import { RobotMover } from "./robot";
import { Timeline } from "./timeline";
import { Store } from "../util/store";
import { NO_ZOOM, type Zoom } from "../util/zoom";

/** A frame with the state that it was made for. */
export interface Shown extends Frame {
  state: OakState;
  scene: string;
  /** The images that were requested; the server leaves out those that the engine does not make. */
  requested: readonly ImageName[];
  /** Whether it is coarser than the images at rest, which follow: its statistics are provisional. */
  isPreview: boolean;
}

/** A message to the person at the page. */
export interface Notice {
  id: number;
  level: Finding["level"];
  text: string;
  findings: Finding[];
}

/** The pixel under the mouse, as fractions of the sensor's image. */
export interface Hover {
  oak: string;
  x: number;
  y: number;
}

/** How long the state must rest before the address follows it, ms. */
const ADDRESS_DELAY = 400;

const BROKEN = "The link is damaged and restores nothing: part of it is missing. Copy it again from where you have it.";

/** How many notices are shown at once. */
const MAX_NOTICES = 4;

/** Everything that the page knows. Components read the stores and call the methods; nothing else changes the stores. */
export class Studio {
  readonly document: History<StudioDocument>;
  readonly display: Store<Display>;
  readonly catalog: Store<Catalog>;
  readonly scene = new Store<SceneInfo | null>(null);
  readonly frames = new Store<ReadonlyMap<string, Shown>>(new Map());
  readonly rejections = new Store<ReadonlyMap<string, Rejection>>(new Map());
  readonly connection = new Store<Connection>("connecting");
  readonly hover = new Store<Hover | null>(null);
  readonly probe = new Store<ProbeAnswer | null>(null);
  /** The part of the large images that is shown: the same of all, to compare them. */
  readonly zoom = new Store<Zoom>(NO_ZOOM);
  /** What the right side bar shows. */
  readonly tab = new Store<"inspect" | "place">("inspect");
  /** The image that fills the middle of the page. */
  readonly maximized = new Store<Side | null>(null);
  /** The dropped files whose units a dialogue asks for. */
  readonly asked = new Store<readonly Asked[]>([]);
  readonly notices = new Store<readonly Notice[]>([]);
  readonly timeline: Timeline;
  readonly motion: Motion;
  readonly calibrations = new Store<ReadonlyMap<string, CalibrationInfo>>(new Map());
  readonly robot = new RobotMover(this);
  private lastNotice = 0;
  private loading = "";

  constructor(catalog: Catalog, first: SceneInfo) {
    this.catalog = new Store(catalog);
    const display = loadDisplay();
    const linked = fromFragment(location.hash, display);
    this.display = new Store(linked?.display ?? display);
    this.document = new History(linked?.document ?? newDocument(catalog, first.id, first.pose));
    if (this.document.get().scene === first.id) this.scene.set(first);
    this.timeline = new Timeline(this);
    this.motion = new Motion(this);
    if (location.hash.length > 1 && !linked) this.notify("error", BROKEN);
    this.followAddress();
    this.display.subscribe(() => saveDisplay(this.display.get()));
    this.document.subscribe(() => void this.followScene());
    void this.followScene();
  }

  /** Changes the selected OAK as a step of undo; changes with the same tag in quick succession are one step. */
  change(tag: string, change: (state: OakState) => OakState): void {
    const { selected } = this.document.get();
    this.document.commit(`${selected}/${tag}`, (document) => changeOak(document, selected, change));
  }

  show(change: Partial<Display>): void {
    this.display.update((display) => ({ ...display, ...change }));
  }

  notify(level: Finding["level"], text: string, findings: Finding[] = []): void {
    const notice = { id: ++this.lastNotice, level, text, findings };
    this.notices.update((notices) => [...notices.filter((other) => other.text !== text), notice].slice(-MAX_NOTICES));
  }

  /** Shows an error of the server or the network. */
  report(context: string, error: unknown): void {
    const text = error instanceof Error ? error.message : String(error);
    this.notify("error", `${context}: ${text}`, error instanceof ApiError ? error.findings : []);
  }

  dismiss(id: number): void {
    this.notices.update((notices) => notices.filter((notice) => notice.id !== id));
  }

  /** Returns the address that restores the current state. */
  link(): string {
    const fragment = toFragment({ document: this.document.get(), display: this.display.get() });
    return `${location.origin}${location.pathname}${fragment}`;
  }

  /** Forgets what a server that was restarted no longer knows, and reads what it knows now. */
  async restart(): Promise<void> {
    const { version } = this.catalog.get();
    this.catalog.set(await api.catalog());
    if (this.catalog.get().version !== version) this.notify("warning", "The server has another version now. Reload the page.");
    this.loading = "";
    this.scene.set(null);
    await this.followScene();
  }

  /** Loads the document's scene if it is not the loaded one. */
  private async followScene(): Promise<void> {
    const { scene } = this.document.get();
    if (scene === this.scene.get()?.id || scene === this.loading) return;
    this.loading = scene;
    try {
      const info = await api.scene(scene);
      if (this.document.get().scene === scene) this.scene.set(info);
    } catch (error) {
      if (this.document.get().scene === scene) await this.replaceScene(error);
    } finally {
      if (this.loading === scene) this.loading = "";
    }
  }

  /** Shows the first scene instead of one that the server does not have (any more). */
  private async replaceScene(error: unknown): Promise<void> {
    const first = this.catalog.get().scene;
    if (!(error instanceof ApiError) || this.document.get().scene === first) {
      if (this.connection.get() === "open") this.report("The scene cannot be loaded", error);
      return;
    }
    const { oaks } = this.document.get();
    this.notify("warning", "The server does not have the scene of this state; drop its file onto the page again.");
    const info = await api.scene(first);
    const known = oaks.map((oak) => ({ ...oak, state: { ...oak.state, pose: info.pose, frame: 0 } }));
    this.document.reset({ ...withScene(this.document.get(), first), oaks: known });
    this.scene.set(info);
  }

  /** Keeps the address of the page such that loading it again, or sending it to somebody, restores the state. */
  private followAddress(): void {
    let timer = 0;
    let own = location.hash;
    const write = () => {
      own = new URL(this.link()).hash;
      history.replaceState(null, "", own);
    };
    const later = () => {
      clearTimeout(timer);
      timer = window.setTimeout(write, ADDRESS_DELAY);
    };
    this.document.subscribe(later);
    this.display.subscribe(later);
    addEventListener("hashchange", () => {
      const linked = location.hash === own ? null : fromFragment(location.hash, this.display.get());
      if (!linked) {
        if (location.hash !== own && location.hash.length > 1) this.notify("error", BROKEN);
        return;
      }
      this.display.set(linked.display);
      this.document.commit("link", () => linked.document);
    });
  }

  /** Whether an OAK can be measured: its model has a depth sensor. */
  hasDepth(state: OakState): boolean {
    return (findModel(this.catalog.get(), state.model)?.depthSensors.length ?? 0) > 0;
  }
}
