import { Live } from "../net/live";
import { FrameScheduler, type Wanted } from "../net/scheduler";
import type { Frame } from "../net/wire";
import type { ImageName, OakState, Rejection, ServerMessage } from "../protocol";
import { type Display, FULL_SIZES, PANELS, shownKinds } from "../state/display";
import { findSensor, type Oak, sceneAt } from "../state/document";
import type { Defaults } from "./defaults";
import type { Probes } from "./probes";
import type { Studio } from "./studio";

/** How long nothing must have changed before images of full size are requested, ms. */
const REST = 150;

/** The limits of images while something moves. The smaller ones are used while an OAK moves and the server takes long to render anew. */
const COARSE: [number, number][] = [[640, 400], [480, 300], [320, 200], [240, 150]];

/** While an OAK moves, every so many pixels of a row and of a column have a colour of their own; those between are interpolated. */
const COLOR_STEP = 3;

/** A frame that takes longer than the first number makes the next one coarser, one below the second finer, ms. */
const SLOW = 50;
const FAST = 20;

/** Fits a sensor's resolution into a limit, with its aspect ratio. Null: the sensor's own. */
export function fit([width, height]: [number, number], limit: [number, number] | null): [number, number] | null {
  const scale = limit ? Math.min(limit[0] / width, limit[1] / height) : 1;
  return scale >= 1 ? null : [Math.round(width * scale), Math.round(height * scale)];
}

/** Returns the images that are shown, in a fixed order. */
export function neededImages(display: Display): ImageName[] {
  const { cloud, cloudColor } = display;
  const kinds = shownKinds(display);
  // Exact and measured depth are always there: the scales, the histogram and the readout depend on them.
  const needed = new Set<ImageName>(["depth", "reference", "sensor"]);
  for (const panel of PANELS) if (kinds.includes(panel.kind)) for (const image of panel.images) needed.add(image);
  if (cloud !== "none" && cloudColor === "reason") needed.add("reason");
  return [...needed].sort();
}

/** Keeps a frame of each OAK that is up to date with the document. */
export class FrameLoop {
  /** The number of frames that arrived. */
  received = 0;
  private readonly live: Live;
  private readonly scheduler: FrameScheduler;
  /** What was last requested of each OAK, to find changes. */
  private readonly requested = new Map<string, readonly unknown[]>();
  /** The requests that were made because an OAK moved. */
  private readonly moving = new WeakSet<Wanted>();
  /** The place in {@link COARSE} of the next such request. */
  private coarseness = 0;
  /** How fine the last request of each OAK was: see {@link limitKey}. */
  private readonly limits = new Map<string, string>();
  private timer = 0;
  private wasLost = false;

  constructor(private readonly studio: Studio, private readonly probes: Probes, private readonly defaults: Defaults) {
    this.live = new Live({
      onConnection: (connection) => this.connected(connection === "open"),
      onFrame: (frame) => this.show(frame),
      onMessage: (message) => this.read(message),
    });
    this.scheduler = new FrameScheduler((request) => this.live.send(request));
    probes.connect((message) => this.live.send(message));
    studio.document.subscribe(() => this.follow());
    studio.display.subscribe(() => this.follow());
    studio.scene.subscribe(() => this.follow());
    studio.timeline.isPlaying.subscribe(() => this.rest());
    this.live.connect();
  }

  /** Whether every frame is there and no change waits for one. */
  get isIdle(): boolean {
    return this.timer === 0 && this.studio.robot.isIdle && this.scheduler.isIdle && this.probes.isIdle && !this.studio.timeline.isPlaying.get();
  }

  private connected(isOpen: boolean): void {
    const { studio } = this;
    studio.connection.set(isOpen ? "open" : "lost");
    this.scheduler.reset();
    this.probes.reset();
    this.requested.clear();
    if (!isOpen) {
      this.wasLost = true;
      return;
    }
    if (this.wasLost) {
      studio.restart().then(() => studio.notify("note", "Connected to the server again."), (error) => studio.report("Reconnecting", error));
    }
    this.wasLost = false;
    this.follow();
  }

  /** Requests what has changed: coarse at once, and in full once nothing changes any more. */
  private follow(): void {
    const { document, scene, connection } = this.studio;
    const { oaks, region, scene: id } = document.get();
    if (connection.get() !== "open" || scene.get()?.id !== id) return;
    this.forgetRemoved(oaks);
    const { fullSize } = this.studio.display.get();
    const images = neededImages(this.studio.display.get());
    for (const oak of oaks) {
      if (oak.isHidden || !this.studio.hasDepth(oak.state)) continue;
      const key = [sceneAt(document.get()), oak.state, ...region, fullSize, ...images];
      const before = this.requested.get(oak.key);
      if (before && before.length === key.length && before.every((part, i) => part === key[i])) continue;
      this.requested.set(oak.key, key);
      // A new parameter needs no new rendering, unless the size changes.
      // The scene is another one at another time, and in another posture of its robot.
      const isMoved = before?.[0] !== key[0] || (before?.[1] as OakState | undefined)?.pose !== oak.state.pose;
      const wanted = this.request(oak, COARSE[isMoved ? this.coarseness : 0] ?? null, images, isMoved ? COLOR_STEP : 1);
      if (isMoved) this.moving.add(wanted);
      this.rest();
    }
  }

  private rest(): void {
    clearTimeout(this.timer);
    this.timer = 0;
    // While the timeline plays, the next frame comes sooner.
    if (this.studio.timeline.isPlaying.get()) return;
    this.timer = window.setTimeout(() => {
      this.timer = 0;
      const { document, display } = this.studio;
      const limit = this.limitAtRest();
      const images = neededImages(display.get());
      for (const oak of document.get().oaks) {
        if (!oak.isHidden && this.studio.hasDepth(oak.state) && this.limits.get(oak.key) !== limitKey(limit, 1)) this.request(oak, limit, images, 1);
      }
    }, REST);
  }

  private limitAtRest(): [number, number] | null {
    const { fullSize } = this.studio.display.get();
    return FULL_SIZES.find(({ size }) => size === fullSize)?.limit ?? null;
  }

  private request(oak: Oak, limit: [number, number] | null, images: ImageName[], colorStep: number): Wanted {
    const { region } = this.studio.document.get();
    const scene = sceneAt(this.studio.document.get());
    const resolution = findSensor(this.studio.catalog.get(), oak.state)?.resolution;
    const size = resolution ? fit(resolution, limit) : null;
    this.limits.set(oak.key, limitKey(limit, colorStep));
    const isPreview = limitKey(limit, colorStep) !== limitKey(this.limitAtRest(), 1);
    const wanted = { oak: oak.key, scene, state: oak.state, size, images, region, colorStep, isPreview };
    this.scheduler.request(wanted);
    return wanted;
  }

  private forgetRemoved(oaks: Oak[]): void {
    const isShown = (key: string) => oaks.some((oak) => oak.key === key && !oak.isHidden);
    const { frames } = this.studio;
    for (const key of this.requested.keys()) {
      if (isShown(key)) continue;
      this.requested.delete(key);
      this.scheduler.forget(key);
    }
    if ([...frames.get().keys()].some((key) => !isShown(key))) {
      frames.set(new Map([...frames.get()].filter(([key]) => isShown(key))));
    }
  }

  private show(frame: Frame): void {
    const { id, oak } = frame.header;
    const wanted = this.scheduler.settle(oak, id);
    if (!wanted) return;
    this.received++;
    if (this.moving.has(wanted)) this.adapt(frame.header.milliseconds);
    this.defaults.learn(wanted.state, frame.header.parameters);
    this.accept(oak, wanted, frame);
    this.probes.refresh(oak);
  }

  private adapt(milliseconds: number): void {
    if (milliseconds > SLOW) this.coarseness = Math.min(this.coarseness + 1, COARSE.length - 1);
    else if (milliseconds < FAST) this.coarseness = Math.max(this.coarseness - 1, 0);
  }

  private accept(oak: string, wanted: Wanted, frame: Frame): void {
    const { frames, rejections } = this.studio;
    if (rejections.get().has(oak)) rejections.set(without(rejections.get(), oak));
    frames.set(new Map(frames.get()).set(oak, {
      ...frame, state: wanted.state, scene: wanted.scene, requested: wanted.images, isPreview: wanted.isPreview === true,
    }));
  }

  private read(message: ServerMessage): void {
    if (message.type === "probe") this.probes.show(message);
    else this.reject(message);
  }

  private reject(rejection: Rejection): void {
    if (this.probes.reject(rejection.id, rejection.oak)) return;
    if (!this.scheduler.settle(rejection.oak, rejection.id)) return;
    this.studio.rejections.set(new Map(this.studio.rejections.get()).set(rejection.oak, rejection));
  }
}

function limitKey(limit: [number, number] | null, colorStep: number): string {
  return `${limit?.join() ?? "native"}/${colorStep}`;
}

function without<T>(map: ReadonlyMap<string, T>, key: string): ReadonlyMap<string, T> {
  return new Map([...map].filter(([other]) => other !== key));
}
