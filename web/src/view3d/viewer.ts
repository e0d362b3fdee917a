import {
  Box3, Box3Helper, BufferGeometry, Color, DirectionalLight, Float32BufferAttribute, GridHelper, Group, HemisphereLight, Line,
  LineBasicMaterial, Matrix4, type Mesh, type MeshLambertMaterial, PerspectiveCamera, Plane, Points, PointsMaterial, Quaternion, Raycaster, Scene, Vector2, Vector3, WebGLRenderer,
} from "three";
import type { Rgb } from "../gpu/colormaps";
import type { Mesh as WireMesh } from "../net/wire";
import type { Pose, SceneInfo, Vec3 } from "../protocol";
import { type UpAxis, upVector } from "../util/pose";
import { Gizmo, type GizmoMode } from "./gizmo";
import { type Box, BoxHandles } from "./boxhandles";
import { makeMesh, makePainting } from "./meshes";
import { Navigation } from "./navigation";
import { dispose } from "./oakobject";
import { OpenLine } from "./openline";
import { RobotParts } from "./robotparts";
import { clipTextured, forgetTextures, makeTextured } from "./textured";
import type { Textured } from "../net/textured";

export interface ViewerHandlers {
  /** The selected OAK was moved in the view. */
  onPose(pose: Pose): void;
  /** The box of the region was moved in the view. */
  onBox(box: Box): void;
  /** A place of the scene was clicked; null for nothing. */
  onPick(hit: Hit | null): void;
  /** The camera of the view moved. */
  onView(): void;
  /** The mouse is over a place of the scene; null for nothing. */
  onHover(hit: Hit | null): void;
  /** The body of an OAK was clicked, by its place among the drawn ones; returns false if what is behind it is meant. */
  onOak(index: number): boolean;
}

/** What a click hits: a point, and the object by its index. */
export interface Hit {
  point: Vector3;
  object: number;
}

/** How far below a roof the scene is cut. */
const ROOF_GAP = 0.03;
const MARKER_COLOR = "#ff2d78";
const RULER_COLOR = "#ffb000";
const PATH_COLOR = "#7c3aed";
/** A pointer that moved less than this between press and release, in pixels, clicked. */
const CLICK = 4;
/** The time between two looks at what is under the mouse, ms. */
const HOVER_PACE = 60;

/** How long after the last movement a processor draws textures again, ms. They take two thirds of the time of an image. */
const SETTLE = 250;

/** Whether a processor draws instead of a graphics card: it has no time to smooth edges. */
function isDrawnBySoftware(): boolean {
  const gl = document.createElement("canvas").getContext("webgl2");
  if (!gl) return true;
  const info = gl.getExtension("WEBGL_debug_renderer_info");
  const name = String(gl.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : gl.RENDERER));
  gl.getExtension("WEBGL_lose_context")?.loseContext();
  return /swiftshader|llvmpipe|softpipe|basic render/i.test(name);
}

/** The 3D view. It draws only after something changed. */
export class Viewer {
  /** The number of images that were drawn. */
  drawn = 0;
  /** The minimum time between two images, ms. */
  pace = 0;
  /** Whether a processor draws the view. */
  readonly isSlow = isDrawnBySoftware();
  readonly navigation: Navigation;
  readonly gizmo: Gizmo;
  private readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  private readonly camera = new PerspectiveCamera(50, 1, 0.02, 1000);
  private readonly oaks = new Group();
  private readonly clouds = new Group();
  private readonly marker: Points<BufferGeometry, PointsMaterial>;
  private readonly sight: Line<BufferGeometry, LineBasicMaterial>;
  private readonly lamp = new DirectionalLight("#ffffff", 1.6);
  private readonly observer: ResizeObserver;
  private mesh: Mesh<BufferGeometry, MeshLambertMaterial> | null = null;
  private grid: GridHelper | null = null;
  private target: Box3Helper | null = null;
  private painting: Mesh<BufferGeometry, MeshLambertMaterial> | null = null;
  private readonly box: BoxHandles;
  private readonly ruler: OpenLine;
  private readonly path: OpenLine;
  private readonly textured = new Group();
  private objects: Uint32Array | null = null;
  private parts: RobotParts | null = null;
  private isWaiting = false;
  private lastDraw = 0;
  private isShown = true;
  /** The timer that ends a movement; 0 while nothing moves. */
  private settling = 0;

  constructor(private readonly canvas: HTMLCanvasElement, handlers: ViewerHandlers) {
    this.renderer = new WebGLRenderer({ canvas, antialias: !this.isSlow, powerPreference: "high-performance" });
    this.renderer.localClippingEnabled = true;
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.scene.add(new HemisphereLight("#ffffff", "#8a8f98", 1.9), this.lamp, this.oaks, this.clouds, this.textured);
    const invalidate = () => this.invalidate();
    this.navigation = new Navigation(this.camera, canvas, () => {
      this.move();
      handlers.onView();
    });
    this.gizmo = new Gizmo(this.camera, canvas, this.scene, this.navigation, handlers.onPose, invalidate);
    const ray = (clientX: number, clientY: number) => this.caster(clientX, clientY);
    this.box = new BoxHandles(canvas, this.scene, this.navigation, ray, handlers.onBox, invalidate);
    this.marker = new Points(
      new BufferGeometry().setAttribute("position", new Float32BufferAttribute([0, 0, 0], 3)),
      new PointsMaterial({ color: MARKER_COLOR, size: 9, sizeAttenuation: false, depthTest: false, transparent: true }),
    );
    this.sight = new Line(
      new BufferGeometry().setAttribute("position", new Float32BufferAttribute([0, 0, 0, 0, 0, 0], 3)),
      new LineBasicMaterial({ color: MARKER_COLOR, transparent: true, opacity: 0.7, depthTest: false }),
    );
    for (const object of [this.marker, this.sight]) {
      object.visible = false;
      object.frustumCulled = false;
      object.renderOrder = 10;
      this.scene.add(object);
    }
    this.observer = new ResizeObserver(() => this.resize());
    this.observer.observe(canvas);
    this.ruler = new OpenLine(this.scene, RULER_COLOR, 8);
    this.path = new OpenLine(this.scene, PATH_COLOR, 4);
    this.listenForClicks(handlers);
    this.listenForHover(handlers);
  }

  close(): void {
    window.clearTimeout(this.settling);
    this.observer.disconnect();
    dispose(this.scene);
    this.renderer.dispose();
  }

  /** Asks for an image; several requests before the next one is drawn are one. */
  invalidate(): void {
    if (this.isWaiting) return;
    this.isWaiting = true;
    const wait = this.lastDraw + this.pace - performance.now();
    if (wait > 0) setTimeout(() => this.draw(), wait);
    else this.draw();
  }

  /** Asks for an image of something that moves: without a graphics card, textures come back when nothing moves any more. */
  move(): void {
    if (this.isSlow && this.textured.children.length) {
      window.clearTimeout(this.settling);
      this.settling = window.setTimeout(() => {
        this.settling = 0;
        this.invalidate();
      }, SETTLE);
    }
    this.invalidate();
  }

  private draw(): void {
    requestAnimationFrame(() => {
      this.isWaiting = false;
      this.lastDraw = performance.now();
      this.lamp.position.copy(this.camera.position);
      this.box.fit(this.camera);
      this.textured.visible = this.isShown && !this.settling;
      this.renderer.render(this.scene, this.camera);
      this.drawn++;
    });
  }

  get isIdle(): boolean {
    return !this.isWaiting && !this.settling;
  }

  setBackground(color: string, gridColor: string): void {
    this.scene.background = new Color(color);
    if (this.grid) this.grid.material.color.set(gridColor);
    this.invalidate();
  }

  setScene(info: SceneInfo, mesh: WireMesh, isTwoSided: boolean): void {
    if (this.mesh) {
      this.scene.remove(this.mesh);
      dispose(this.mesh);
    }
    this.mesh = makeMesh(mesh, isTwoSided);
    this.objects = mesh.objects;
    this.parts = info.robot ? new RobotParts(this.mesh.geometry, mesh.objects, info, info.robot) : null;
    this.scene.add(this.mesh);
    this.setTextured(null);
    const size = new Vector3(...info.bounds[1]).distanceTo(new Vector3(...info.bounds[0]));
    this.camera.near = Math.min(0.05, Math.max(size / 5000, 0.001));
    this.camera.far = Math.max(100, size * 10);
    this.camera.updateProjectionMatrix();
    this.invalidate();
  }

  /** Draws textures over the scene; null for none. */
  setTextured(surfaces: Textured | null): void {
    forgetTextures(this.textured);
    dispose(this.textured);
    this.textured.clear();
    if (surfaces && this.mesh) {
      this.textured.add(...makeTextured(surfaces).children);
      clipTextured(this.textured, this.mesh.material.clippingPlanes);
    }
    this.invalidate();
  }

  /** Moves the robot of the scene to its posture. */
  moveRobot(info: SceneInfo): void {
    if (info.robot && this.parts?.isOf(info)) this.parts.move(info.robot);
    this.move();
  }

  showScene(isShown: boolean): void {
    if (this.mesh) this.mesh.visible = isShown;
    this.isShown = isShown;
    this.invalidate();
  }

  /** Finds the height of what is above a point, such as a ceiling. */
  roofAbove(info: SceneInfo, position: Vec3): number | null {
    if (!this.mesh) return null;
    const up = new Vector3(...upVector(info.up));
    // A ceiling shows its face to the room, so that culling does not hide it from the ray.
    const hit = new Raycaster(new Vector3(...position), up).intersectObject(this.mesh)[0];
    return hit ? hit.point.dot(up) : null;
  }

  /** Cuts away the scene above a height; null for nothing. */
  setRoof(info: SceneInfo, height: number | null): void {
    if (!this.mesh) return;
    const down = new Vector3(...upVector(info.up)).negate();
    this.mesh.material.clippingPlanes = height === null ? null : [new Plane(down, height - ROOF_GAP)];
    if (this.painting) this.painting.material.clippingPlanes = this.mesh.material.clippingPlanes;
    clipTextured(this.textured, this.mesh.material.clippingPlanes);
    this.invalidate();
  }

  /** Draws a grid of metres below the scene. */
  setGrid(info: SceneInfo, isShown: boolean, color: string): void {
    if (this.grid) {
      this.scene.remove(this.grid);
      dispose(this.grid);
      this.grid = null;
    }
    if (isShown) {
      const [low, high] = info.bounds;
      const [width, depth] = info.up === "z" ? [high[0] - low[0], high[1] - low[1]] : [high[0] - low[0], high[2] - low[2]];
      const size = Math.min(100, Math.max(4, 2 * Math.ceil(Math.max(width, depth) / 2) + 2));
      this.grid = new GridHelper(size, size, color, color);
      if (info.up === "z") this.grid.rotation.x = Math.PI / 2;
      const centre = new Vector3(...low).add(new Vector3(...high)).multiplyScalar(0.5).round();
      // A little lower than the floor, which would otherwise flicker.
      if (info.up === "z") centre.z = low[2] - 0.01;
      else centre.y = low[1] - 0.01;
      this.grid.position.copy(centre);
      this.scene.add(this.grid);
    }
    this.invalidate();
  }

  setOaks(groups: Group[]): void {
    dispose(this.oaks);
    this.oaks.clear();
    if (groups.length) this.oaks.add(...groups);
    this.invalidate();
  }

  setClouds(clouds: Points[]): void {
    dispose(this.clouds);
    this.clouds.clear();
    if (clouds.length) this.clouds.add(...clouds);
    this.invalidate();
  }

  /** Marks a point of the scene and the line of sight to it. */
  setMarker(point: Vec3 | null, eye: Vec3 | null): void {
    this.marker.visible = point !== null;
    this.sight.visible = point !== null && eye !== null;
    if (point) this.marker.position.set(...point);
    if (point && eye) {
      const positions = this.sight.geometry.getAttribute("position");
      positions.setXYZ(0, ...eye);
      positions.setXYZ(1, ...point);
      positions.needsUpdate = true;
    }
    this.invalidate();
  }

  /** Shows up to two points and the line between them. */
  setRuler(points: readonly Vec3[]): void {
    this.ruler.set(points);
    this.invalidate();
  }

  /** Shows the way of a trajectory. */
  setPath(points: readonly Vec3[]): void {
    this.path.set(points);
    this.invalidate();
  }

  /** Returns what the view shows as a PNG. */
  picture(): Promise<Blob | null> {
    this.textured.visible = this.isShown;
    // Within one task: a canvas is empty once the page has shown it.
    this.renderer.render(this.scene, this.camera);
    return new Promise((resolve) => this.canvas.toBlob(resolve, "image/png"));
  }

  /** Paints a surface; `color` is that of a number in the place of a triangle's object. */
  setPainting(mesh: WireMesh | null, color: (object: number) => Rgb): void {
    if (this.painting) {
      this.scene.remove(this.painting);
      dispose(this.painting);
      this.painting = null;
    }
    if (mesh) {
      this.painting = makePainting(mesh, color);
      this.painting.material.clippingPlanes = this.mesh?.material.clippingPlanes ?? null;
      this.scene.add(this.painting);
    }
    this.invalidate();
  }

  /** Outlines the region whose coverage is computed; a box can be moved by handles. */
  setTarget(bounds: Box | null, isMovable: boolean, up: UpAxis): void {
    this.box.set(isMovable ? bounds : null, up);
    if (this.target) {
      this.scene.remove(this.target);
      this.target.dispose();
      this.target = null;
    }
    if (bounds) {
      const box = new Box3(new Vector3(...bounds[0]), new Vector3(...bounds[1]));
      this.target = new Box3Helper(box, new Color("#d6409f"));
      this.scene.add(this.target);
    }
    this.invalidate();
  }

  setGizmo(mode: GizmoMode, pose: Pose | null): void {
    this.gizmo.set(mode, pose);
    this.invalidate();
  }

  /** Looks at an OAK from behind and above, such that what it sees is visible; more steeply into a room without its roof. */
  lookAt(info: SceneInfo, pose: Pose, isRoom: boolean): void {
    const up = new Vector3(...upVector(info.up));
    const [low, high] = [new Vector3(...info.bounds[0]), new Vector3(...info.bounds[1])];
    const body = new Vector3(...pose.position);
    const size = Math.min(Math.max(low.distanceTo(high), 1), 8);
    const forward = new Vector3(1, 0, 0).applyQuaternion(this.oaks.quaternion.clone().set(...pose.quaternion));
    forward.addScaledVector(up, -forward.dot(up));
    if (forward.length() < 0.1) forward.set(1, 0, 0);
    forward.normalize();
    const side = new Vector3().crossVectors(up, forward);
    const target = body.clone().addScaledVector(forward, size * 0.2);
    const [back, right, rise] = isRoom ? [0.12, 0.12, 0.62] : [0.3, 0.22, 0.25];
    const from = body.clone().addScaledVector(forward, -size * back).addScaledVector(side, -size * right).addScaledVector(up, size * rise);
    this.navigation.look(info.up, target, from);
  }

  /** Returns the pose of a body that looks as the view does. */
  pose(): Pose {
    // A body's x axis is forward, y left and z up; a camera's x axis is right, y up and z backward.
    const axes = new Matrix4().makeBasis(new Vector3(0, 0, -1), new Vector3(-1, 0, 0), new Vector3(0, 1, 0));
    const { x, y, z, w } = this.camera.quaternion.clone().multiply(new Quaternion().setFromRotationMatrix(axes));
    return { position: this.camera.position.toArray(), quaternion: [x, y, z, w] };
  }

  /** Finds what a place of the canvas shows, given in pixels of the page. */
  hit(clientX: number, clientY: number): Hit | null {
    if (!this.mesh?.visible) return null;
    const planes = this.mesh.material.clippingPlanes ?? [];
    const hits = this.caster(clientX, clientY).intersectObject(this.mesh);
    const first = hits.find(({ point }) => planes.every((plane) => plane.distanceToPoint(point) >= 0));
    if (!first || first.faceIndex == null) return null;
    return { point: first.point, object: this.objects?.[first.faceIndex] ?? 0 };
  }

  private caster(clientX: number, clientY: number): Raycaster {
    const { left, top, width, height } = this.canvas.getBoundingClientRect();
    const caster = new Raycaster();
    caster.setFromCamera(new Vector2(((clientX - left) / width) * 2 - 1, 1 - ((clientY - top) / height) * 2), this.camera);
    return caster;
  }

  /** Finds the OAK whose body is at a place of the canvas and before a point of the scene. */
  private oakAt(clientX: number, clientY: number, before: Vector3 | null): number | null {
    const caster = this.caster(clientX, clientY);
    const limit = before ? caster.ray.origin.distanceTo(before) : Number.POSITIVE_INFINITY;
    // The first child of an OAK is its body; the others are lines and transparent planes.
    const bodies = this.oaks.children.map((oak) => oak.children[0]).filter((body) => body !== undefined);
    const hit = caster.intersectObjects(bodies).find(({ object, distance }) => (object as Mesh).isMesh && distance < limit);
    const index = bodies.findIndex((body) => hit && (body === hit.object || body === hit.object.parent));
    return index < 0 ? null : index;
  }

  private listenForClicks({ onPick, onOak }: ViewerHandlers): void {
    let start: [number, number] | null = null;
    this.canvas.addEventListener("pointerdown", (event) => {
      start = event.button === 0 && !this.gizmo.isActive && !this.box.isActive ? [event.clientX, event.clientY] : null;
    });
    this.canvas.addEventListener("pointerup", (event) => {
      if (!start || Math.hypot(event.clientX - start[0], event.clientY - start[1]) > CLICK) return;
      const scene = this.hit(event.clientX, event.clientY);
      const oak = this.oakAt(event.clientX, event.clientY, scene?.point ?? null);
      if (oak === null || !onOak(oak)) onPick(scene);
    });
    this.canvas.addEventListener("dblclick", (event) => {
      const hit = this.hit(event.clientX, event.clientY);
      if (hit) this.navigation.focus(hit.point, Math.max(0.3, this.camera.position.distanceTo(hit.point) * 0.5));
    });
  }

  private listenForHover({ onHover }: ViewerHandlers): void {
    let timer = 0;
    let last: PointerEvent | null = null;
    this.canvas.addEventListener("pointermove", (event) => {
      // Looking for the place would hold up a movement of the view.
      last = event.buttons === 0 ? event : null;
      timer ||= window.setTimeout(() => {
        timer = 0;
        if (last) onHover(this.hit(last.clientX, last.clientY));
      }, HOVER_PACE);
    });
    this.canvas.addEventListener("pointerleave", () => {
      last = null;
      onHover(null);
    });
  }

  private resize(): void {
    const { clientWidth, clientHeight } = this.canvas;
    if (clientWidth === 0 || clientHeight === 0) return;
    this.renderer.setSize(clientWidth, clientHeight, false);
    this.camera.aspect = clientWidth / clientHeight;
    this.camera.updateProjectionMatrix();
    this.invalidate();
  }
}
