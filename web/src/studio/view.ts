import type { Group } from "three";
import { Matrix4, Quaternion, Vector3 } from "three";
import { depthTable, errorTable, oakColor, outcomeColor, reasonTable } from "../gpu/colormaps";
import { findScales } from "../gpu/scales";
import { api } from "../net/api";
import type { Mesh } from "../net/wire";
import type { Pose, SceneInfo, Vec3 } from "../protocol";
import type { Display } from "../state/display";
import { findModel, findSensor, type Oak, selectedOak, type StudioDocument, type Target, sceneAt } from "../state/document";
import { reflecting } from "../state/infrared";
import { Store } from "../util/store";
import { makeCloud, placeCloud, showThrough } from "../view3d/cloud";
import type { GizmoMode } from "../view3d/gizmo";
import { makeOak, matrix, place } from "../view3d/oakobject";
import { type Hit, Viewer } from "../view3d/viewer";
import { Painting } from "./painting";
import { visiblePixel } from "./project";
import { unposed } from "./robot";
import type { Shown, Studio } from "./studio";

/** How many triangles of a scene are loaded: what can be turned without a GPU at 10 images per second. */
const TRIANGLES = 100_000;
const FULL_DETAIL = 5_000_000;

/** How many points all clouds have together: drawing them is what takes time without a GPU. */
const MAX_POINTS = 300_000;

/** The time between two images of the 3D view while an OAK flies without a graphics card: the images of the OAK come first, ms. */
const FLIGHT_PACE = 150;
/** The time between two poses of an OAK that flies, ms. */
const RIDE_PACE = 30;

/** A place of the scene under the mouse. */
export interface Pointed {
  point: Vec3;
  /** The path of the object. */
  object: string | null;
  /** From the body of the selected OAK. */
  distanceM: number | null;
  /** Whether the depth sensor's camera of the selected OAK sees it. */
  isSeen: boolean;
}

/** Keeps the 3D view up to date with what the page knows. */
export class SceneView {
  readonly gizmo = new Store<GizmoMode>("translate");
  /** Whether the next click in the view chooses the object whose coverage is computed. */
  readonly isPicking = new Store(false);
  /** What is under the mouse. */
  readonly pointed = new Store<Pointed | null>(null);
  /** The points of the ruler, at most two; null if it is not used. */
  readonly ruler = new Store<readonly Vec3[] | null>(null);
  /** Whether the selected OAK moves with the view. */
  readonly isRiding = new Store(false);
  /** The triangles that are drawn, and those that the scene has. */
  readonly detail = new Store<{ shown: number; of: number } | null>(null);
  readonly viewer: Viewer;
  /** What the selected OAK measures of the region's surface. */
  readonly painting: Painting;
  private readonly bodies = new Map<string, Mesh | null>();
  private groups: { oak: Oak; group: Group }[] = [];
  private readonly seen = new Map<string, readonly unknown[]>();
  private hasClouds = false;
  private mesh: Mesh | null = null;
  /** The scene of the mesh, at its time. */
  private loaded = "";
  private isLoading = false;
  private wantsDetail = false;
  /** The timer of the next pose of an OAK that flies. */
  private ridden = 0;
  /** The height of what covered the OAK when the scene was loaded. */
  private roof: number | null = null;

  constructor(private readonly studio: Studio, canvas: HTMLCanvasElement) {
    this.viewer = new Viewer(canvas, {
      onPose: (pose) => this.movePose(pose),
      onPick: (hit) => this.pick(hit),
      onHover: (hit) => this.point(hit),
      onOak: (index) => this.select(index),
      onView: () => this.ride(),
      onBox: ([minimum, maximum]) => studio.document.commit("target box", (document) => ({ ...document, target: { minimum, maximum } })),
    });
    this.painting = new Painting(studio);
    this.painting.subscribe(() => this.viewer.setPainting(this.painting.get().mesh, outcomeColor));
    const { document, display, scene, frames, probe } = studio;
    scene.subscribe(() => void this.loadScene());
    for (const store of [document, display, this.gizmo, this.isRiding]) store.subscribe(() => this.follow());
    document.subscribe(() => this.followTime());
    studio.timeline.trajectories.all.subscribe(() => this.follow());
    studio.timeline.isPlaying.subscribe(() => void this.loadTextures(this.loaded));
    frames.subscribe(() => this.followClouds());
    probe.subscribe(() => this.followProbe());
    this.ruler.subscribe(() => this.viewer.setRuler(this.ruler.get() ?? []));
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.paintBackground());
    this.follow();
    void this.loadScene();
  }

  /** Whether everything is drawn. */
  get isIdle(): boolean {
    return this.viewer.isIdle && this.painting.isIdle && !this.isLoading;
  }

  /** Looks at the selected OAK from behind. */
  home(): void {
    const [info, oak] = [this.studio.scene.get(), selectedOak(this.studio.document.get())];
    if (info && oak) this.viewer.lookAt(info, oak.state.pose, this.roof !== null && !this.studio.display.get().showRoof);
  }

  /** Looks from where the selected OAK is. */
  lookThrough(): void {
    const oak = selectedOak(this.studio.document.get());
    if (oak) this.viewer.navigation.lookAlong(oak.state.pose);
  }

  /** Couples the selected OAK with the view, or releases it. */
  setRiding(isOn: boolean): void {
    if (isOn) this.lookThrough();
    this.viewer.pace = isOn && this.viewer.isSlow ? FLIGHT_PACE : 0;
    this.isRiding.set(isOn);
  }

  /** Loads every triangle of the scene, for a computer with a GPU. */
  loadFullDetail(): void {
    this.wantsDetail = true;
    this.loaded = "";
    void this.loadScene();
  }

  paintBackground(): void {
    const style = getComputedStyle(document.documentElement);
    const { scene, display } = this.studio;
    const grid = style.getPropertyValue("--grid").trim();
    this.viewer.setBackground(style.getPropertyValue("--view").trim(), grid);
    const info = scene.get();
    if (info) this.viewer.setGrid(info, display.get().showGrid, grid);
  }

  private async loadScene(): Promise<void> {
    const info = this.studio.scene.get();
    // A server that was restarted may have another scene under the same name.
    if (!info) this.loaded = "";
    if (!info || info.id !== this.studio.document.get().scene) return;
    const scene = visible(this.studio.document.get());
    if (scene === this.loaded) return;
    const isPosture = info.robot !== null && unposed(scene) === unposed(this.loaded);
    this.loaded = scene;
    if (isPosture) return this.viewer.moveRobot(info);
    const isFirst = this.isNew("place", unposed(scene), ...info.bounds.flat());
    this.isLoading = true;
    try {
      const mesh = await api.sceneMesh(scene, this.wantsDetail ? FULL_DETAIL : TRIANGLES);
      this.wantsDetail = false;
      const now = this.studio.scene.get();
      if (!now || unposed(now.id) !== unposed(info.id)) return;
      this.viewer.setScene(info, mesh, false);
      this.viewer.moveRobot(now);
      this.mesh = mesh;
      this.detail.set({ shown: mesh.header.triangles, of: mesh.header.ofTriangles });
      if (isFirst) this.roof = this.viewer.roofAbove(info, info.pose.position);
      if (isFirst) this.home();
      this.follow();
      await this.loadTextures(scene);
    } catch (error) {
      this.loaded = "";
      if (this.studio.connection.get() === "open") this.studio.report("The 3D view", error);
    } finally {
      this.isLoading = false;
    }
    this.followTime();
  }

  /** Loads the textures of the scene as it is at rest; without them, surfaces have the mean colours of their textures. */
  private async loadTextures(scene: string): Promise<void> {
    if (scene === "" || this.studio.timeline.isPlaying.get()) return;
    try {
      const surfaces = await api.sceneTextures(scene);
      if (this.loaded === scene && surfaces.groups.length) this.viewer.setTextured(surfaces);
    } catch {
      // The mean colours remain.
    }
  }

  /** Shows the scene at another time, as often as its mesh arrives. */
  private followTime(): void {
    const document = this.studio.document.get();
    if (!this.isLoading && this.loaded !== "" && this.loaded !== visible(document)) void this.loadScene();
  }

  /** Passes on what has changed; drawing without a GPU is slow, so nothing else may cause it. */
  private follow(): void {
    const { document, display, scene } = this.studio;
    const [shown, state, info] = [display.get(), document.get(), scene.get()];
    this.followOaks(state.oaks, state.selected, shown);
    const [mode, pose] = [this.isRiding.get() ? "none" : this.gizmo.get(), selectedOak(state)?.state.pose ?? null];
    if (this.isNew("gizmo", mode, pose)) this.viewer.setGizmo(mode, pose);
    if (this.isNew("scene", this.mesh, shown.showScene)) this.viewer.showScene(shown.showScene);
    const roof = shown.showRoof ? null : this.roof;
    if (info && this.isNew("roof", this.mesh, roof)) this.viewer.setRoof(info, roof);
    if (this.isNew("target", state.target, info)) {
      const isBox = state.target !== null && "minimum" in state.target;
      this.viewer.setTarget(targetBounds(state.target, info), isBox, info?.up ?? "z");
    }
    const path = this.studio.timeline.trajectories.current();
    if (this.isNew("path", path)) this.viewer.setPath(path?.poses.map(({ position }) => position) ?? []);
    if (this.isNew("background", info, shown.showGrid, shown.theme)) this.paintBackground();
    this.followClouds();
  }

  /** Whether values differ from those of the last call with this name. */
  private isNew(name: string, ...values: unknown[]): boolean {
    const before = this.seen.get(name);
    this.seen.set(name, values);
    return !before || before.length !== values.length || values.some((value, i) => value !== before[i]);
  }

  /** Makes the OAKs again only if more than their poses changed. */
  private followOaks(oaks: Oak[], selected: string, shown: Display): void {
    const visible = oaks.filter((oak) => !oak.isHidden);
    const isRiding = this.isRiding.get();
    const looks = JSON.stringify([
      selected, isRiding, shown.showCameras, shown.showRanges,
      visible.map(({ key, state }) => [key, state.model, state.sensor, this.bodies.get(state.model) ? 1 : 0]), oaks.map(({ key }) => key),
    ]);
    if (this.isNew("looks", looks)) {
      this.groups = visible.flatMap((oak) => this.makeGroup(oak, oaks.indexOf(oak), oak.key === selected, shown));
      this.viewer.setOaks(this.groups.map(({ group }) => group));
    }
    if (!this.isNew("poses", looks, ...visible.map(({ state }) => state.pose))) return;
    for (const entry of this.groups) {
      const oak = oaks.find(({ key }) => key === entry.oak.key);
      if (oak) place(entry.group, oak.state.pose);
      // Linked OAKs ride along; from inside, their bodies would fill the view.
      const { arePosesLinked } = this.studio.document.get();
      entry.group.visible = !isRiding || (entry.oak.key !== selected && !arePosesLinked);
    }
    this.viewer.move();
  }

  private makeGroup(oak: Oak, index: number, isSelected: boolean, shown: Display): { oak: Oak; group: Group }[] {
    const catalog = this.studio.catalog.get();
    const model = findModel(catalog, oak.state.model);
    if (!model) return [];
    void this.loadBody(model.name);
    const group = makeOak({
      model,
      sensor: findSensor(catalog, oak.state),
      body: this.bodies.get(model.name) ?? null,
      color: oakColor(index),
      isSelected,
      showCameras: shown.showCameras,
      showRanges: shown.showRanges,
    });
    return [{ oak, group }];
  }

  private async loadBody(model: string): Promise<void> {
    if (this.bodies.has(model)) return;
    this.bodies.set(model, null);
    try {
      this.bodies.set(model, await api.body(model));
      this.follow();
    } catch {
      // The box remains, which has the right size.
    }
  }

  private followClouds(): void {
    const { studio } = this;
    const shown = studio.display.get();
    const frames = studio.frames.get();
    const { depthMap, depthRange, errorRange, errorUnit, cloud, cloudColor } = shown;
    if (cloud === "none" && !this.hasClouds) return;
    if (!this.isNew("clouds", depthMap, depthRange, errorRange, errorUnit, cloud, cloudColor, ...frames.values())) return;
    this.hasClouds = cloud !== "none";
    const oaks = studio.document.get().oaks;
    this.viewer.setClouds(cloud === "none" ? [] : [...frames].flatMap(([oak, frame]) => {
      return this.makeClouds(frame, oaks.findIndex(({ key }) => key === oak), shown, frames);
    }));
  }

  private makeClouds(frame: Shown, index: number, shown: Display, frames: ReadonlyMap<string, Shown>) {
    const sensor = findSensor(this.studio.catalog.get(), frame.state);
    if (!sensor) return [];
    const { pictures, header } = frame;
    const truth = pictures.get("reference") ?? pictures.get("depth");
    const measured = pictures.get("sensor");
    // Pixels without a value have a reason, and no measured place.
    const placed = shown.cloudColor === "reason" ? truth : measured;
    const sources = shown.cloud === "both" ? [truth, measured] : [shown.cloud === "truth" ? truth : placed];
    const scales = findScales(frames.values(), shown);
    const mode = shown.cloudColor;
    const [red, green, blue] = oakColor(Math.max(index, 0));
    const pose = new Matrix4().compose(
      new Vector3(...frame.state.pose.position), new Quaternion(...frame.state.pose.quaternion), new Vector3(1, 1, 1));
    return sources.filter((depth) => depth !== undefined).map((depth) => {
      const isGrey = shown.cloud === "both" && depth === truth;
      const points = makeCloud({
        depth,
        truth,
        measured,
        reasons: pictures.get("reason"),
        hfovDeg: header.hfovDeg,
        vfovDeg: header.vfovDeg,
        mode: isGrey ? "oak" : mode,
        table: mode === "error" ? errorTable() : mode === "reason" ? reasonTable() : depthTable(shown.depthMap),
        range: mode === "error" ? [0, scales.error] : scales.depth,
        isRelative: shown.errorUnit === "%",
        color: isGrey ? [0.62, 0.64, 0.68] : [red / 255, green / 255, blue / 255],
        pointSize: 2,
        maxPoints: MAX_POINTS / (frames.size * sources.length),
      });
      placeCloud(points, pose, matrix(sensor.bodyFromCamera));
      // What is measured too far lies behind the surfaces of the scene.
      if (mode === "error" && depth === measured) showThrough(points);
      return points;
    });
  }

  private followProbe(): void {
    const { probe, frames, catalog } = this.studio;
    const answer = probe.get();
    const frame = answer && frames.get().get(answer.oak);
    const sensor = frame && findSensor(catalog.get(), frame.state);
    if (!answer?.point || !frame || !sensor) return this.viewer.setMarker(null, null);
    const rows = sensor.bodyFromCamera;
    const eye = new Vector3(rows[3], rows[7], rows[11]).applyQuaternion(new Quaternion(...frame.state.pose.quaternion));
    this.viewer.setMarker(answer.point, eye.add(new Vector3(...frame.state.pose.position)).toArray() as Vec3);
  }

  /** Moves the selected OAK to where the view is, not more often than images could follow. */
  private ride(): void {
    if (!this.isRiding.get() || this.ridden) return;
    this.ridden = window.setTimeout(() => {
      this.ridden = 0;
      if (this.isRiding.get()) this.movePose(this.viewer.pose());
    }, RIDE_PACE);
  }

  private movePose(pose: Pose): void {
    this.studio.change("pose", (state) => ({ ...state, pose }));
  }

  private select(index: number): boolean {
    if (this.ruler.get()) return false;
    const selected = this.groups[index]?.oak.key;
    if (selected) this.studio.document.set({ ...this.studio.document.get(), selected });
    return true;
  }

  /** Notes what is under the mouse, and probes the pixel of the selected OAK that shows it. */
  private point(hit: Hit | null): void {
    const { studio } = this;
    const oak = selectedOak(studio.document.get());
    const point = hit?.point.toArray() as Vec3 | undefined;
    if (!hit || !point) {
      // The mark of what the mouse has left would cover handles.
      if (this.pointed.get()?.isSeen) studio.hover.set(null);
      return this.pointed.set(null);
    }
    const frame = oak && studio.frames.get().get(oak.key);
    const sensor = frame && findSensor(studio.catalog.get(), frame.state);
    const pixel = sensor ? visiblePixel(frame, sensor, point) : null;
    this.pointed.set({
      point,
      object: studio.scene.get()?.objects[hit.object]?.path ?? null,
      distanceM: oak ? new Vector3(...oak.state.pose.position).distanceTo(hit.point) : null,
      isSeen: pixel !== null,
    });
    if (this.isRiding.get()) return;
    studio.hover.set(oak && pixel ? { oak: oak.key, ...pixel } : null);
  }

  private pick(hit: Hit | null): void {
    const ends = this.ruler.get();
    if (ends && hit) return this.ruler.set([...(ends.length < 2 ? ends : []), hit.point.toArray() as Vec3]);
    if (!this.isPicking.get()) return;
    const object = hit === null ? undefined : this.studio.scene.get()?.objects[hit.object];
    if (!object) return;
    this.isPicking.set(false);
    this.studio.document.commit("target", (document) => ({ ...document, target: { object: object.path } }));
  }
}

/** Returns the scene that the view shows, which has no infrared light. */
function visible(document: StudioDocument): string {
  return reflecting(sceneAt(document), []);
}

/** Returns the box of a region. */
export function targetBounds(target: Target | null, scene: SceneInfo | null): [Vec3, Vec3] | null {
  if (!target) return null;
  if ("minimum" in target) return [target.minimum, target.maximum];
  const own = scene?.objects.filter(({ path }) => path === target.object || path.startsWith(`${target.object}/`)) ?? [];
  const [first] = own;
  if (!first) return null;
  return own.reduce(([low, high], { bounds }): [Vec3, Vec3] => [
    low.map((value, axis) => Math.min(value, bounds[0][axis] ?? value)) as Vec3,
    high.map((value, axis) => Math.max(value, bounds[1][axis] ?? value)) as Vec3,
  ], first.bounds);
}
