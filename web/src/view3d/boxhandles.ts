import { BoxGeometry, Group, Mesh, MeshBasicMaterial, type PerspectiveCamera, Plane, type Raycaster, type Scene, SphereGeometry, Vector3 } from "three";
import type { Vec3 } from "../protocol";
import type { UpAxis } from "../util/pose";
import type { Navigation } from "./navigation";

export type Box = [Vec3, Vec3];

/** The size of a handle, as a share of its distance. */
const SIZE = 0.02;
/** A box cannot become thinner than this, metres. */
const THINNEST = 0.01;
/** The handle in the centre; those before it are on the faces, two for each axis. */
const CENTRE = 6;
const COLOR = "#d6409f";
const HOVERED = "#ffffff";

/** Handles on the faces and in the centre of a box, which resize and move it. */
export class BoxHandles {
  private readonly group = new Group();
  private readonly handles: Mesh<BoxGeometry | SphereGeometry, MeshBasicMaterial>[];
  private box: Box | null = null;
  private up: UpAxis = "z";
  private hovered = -1;
  /** The handle that is dragged, with the box and the place where the drag began. */
  private drag: { handle: number; box: Box; from: Vector3; isVertical: boolean } | null = null;

  constructor(
    private readonly canvas: HTMLCanvasElement,
    scene: Scene,
    private readonly navigation: Navigation,
    private readonly ray: (clientX: number, clientY: number) => Raycaster,
    private readonly onBox: (box: Box) => void,
    private readonly onChange: () => void,
  ) {
    this.handles = Array.from({ length: CENTRE + 1 }, (_, i) => {
      const material = new MeshBasicMaterial({ color: COLOR, depthTest: false, transparent: true, opacity: 0.9 });
      const handle = new Mesh(i === CENTRE ? new SphereGeometry(0.75, 16, 12) : new BoxGeometry(1, 1, 1), material);
      handle.renderOrder = 11;
      return handle;
    });
    this.group.add(...this.handles);
    this.group.visible = false;
    scene.add(this.group);
    canvas.addEventListener("pointermove", (event) => this.hover(event));
    canvas.addEventListener("pointerdown", (event) => this.grab(event));
  }

  /** Whether the pointer is on a handle or drags it. */
  get isActive(): boolean {
    return this.hovered >= 0 || this.drag !== null;
  }

  set(box: Box | null, up: UpAxis): void {
    this.box = box;
    this.up = up;
    this.group.visible = box !== null;
    if (!box) this.hovered = -1;
    this.handles.forEach((handle, i) => box && handle.position.copy(place(box, i)));
  }

  /** Gives the handles the same size on the screen wherever they are. */
  fit(camera: PerspectiveCamera): void {
    if (!this.box) return;
    for (const handle of this.handles) handle.scale.setScalar(SIZE * camera.position.distanceTo(handle.position));
  }

  private find(event: PointerEvent): number {
    if (!this.box) return -1;
    const hits = this.ray(event.clientX, event.clientY).intersectObjects(this.handles);
    return this.handles.findIndex((handle) => handle === hits[0]?.object);
  }

  private hover(event: PointerEvent): void {
    if (this.drag || event.buttons !== 0) return;
    const found = this.find(event);
    if (found === this.hovered) return;
    this.hovered = found;
    this.canvas.style.cursor = found >= 0 ? "grab" : "";
    this.handles.forEach((handle, i) => handle.material.color.set(i === found ? HOVERED : COLOR));
    this.onChange();
  }

  private grab(event: PointerEvent): void {
    const handle = event.button === 0 ? this.find(event) : -1;
    if (handle < 0 || !this.box) return;
    const drag = { handle, box: this.box, from: new Vector3(), isVertical: event.shiftKey };
    const from = this.reach(event, drag);
    if (!from) return;
    this.drag = { ...drag, from };
    this.navigation.isEnabled = false;
    const move = (next: PointerEvent) => this.move(next);
    const end = () => {
      this.drag = null;
      this.navigation.isEnabled = true;
      removeEventListener("pointermove", move);
      removeEventListener("pointerup", end);
      removeEventListener("pointercancel", end);
    };
    addEventListener("pointermove", move);
    addEventListener("pointerup", end);
    addEventListener("pointercancel", end);
  }

  private move(event: PointerEvent): void {
    const { drag } = this;
    const to = drag && this.reach(event, drag);
    if (!drag || !to) return;
    const by = to.sub(drag.from).toArray() as Vec3;
    const next: Box = [[...drag.box[0]], [...drag.box[1]]];
    if (drag.handle === CENTRE) {
      for (const corner of next) corner.forEach((value, axis) => (corner[axis] = value + (by[axis] ?? 0)));
    } else {
      const [axis, end] = [drag.handle >> 1, drag.handle & 1];
      const [low, high] = [drag.box[0][axis] ?? 0, drag.box[1][axis] ?? 0];
      const moved = (end ? high : low) + (by[axis] ?? 0);
      (next[end] as Vec3)[axis] = end ? Math.max(moved, low + THINNEST) : Math.min(moved, high - THINNEST);
    }
    this.onBox(next.map((corner) => corner.map((value) => Number(value.toFixed(4)))) as Box);
  }

  /** Returns the point that the pointer drags: on the axis of a face, or for the centre in the level plane, with Shift on the vertical. */
  private reach(event: PointerEvent, { handle, box, isVertical }: { handle: number; box: Box; isVertical: boolean }): Vector3 | null {
    const { ray } = this.ray(event.clientX, event.clientY);
    const start = place(box, handle);
    const up = this.up === "z" ? 2 : 1;
    if (handle !== CENTRE || isVertical) return nearest(ray.origin, ray.direction, start, unit(handle === CENTRE ? up : handle >> 1));
    return ray.intersectPlane(new Plane().setFromNormalAndCoplanarPoint(unit(up), start), new Vector3());
  }
}

function unit(axis: number): Vector3 {
  return new Vector3().setComponent(axis, 1);
}

/** The place of a handle. */
function place([low, high]: Box, handle: number): Vector3 {
  const centre = new Vector3(...low).add(new Vector3(...high)).multiplyScalar(0.5);
  if (handle !== CENTRE) centre.setComponent(handle >> 1, (handle & 1 ? high : low)[handle >> 1] ?? 0);
  return centre;
}

/** Returns the point of a line that is nearest to a ray; null if they are parallel. */
export function nearest(origin: Vector3, direction: Vector3, start: Vector3, axis: Vector3): Vector3 | null {
  const between = origin.clone().sub(start);
  const cosine = axis.dot(direction);
  const square = 1 - cosine * cosine;
  if (square < 1e-4) return null;
  const along = (axis.dot(between) - cosine * direction.dot(between)) / square;
  return start.clone().addScaledVector(axis, along);
}
