import { type PerspectiveCamera, Vector3 } from "three";
import type { Pose } from "../protocol";
import { rotate, type UpAxis } from "../util/pose";

const TURN_PER_PIXEL = 0.006;
const ZOOM_PER_STEP = 1.0015;
/** Close to the poles the view would flip. */
const MAX_ELEVATION = Math.PI / 2 - 0.02;
/** The keys that fly: forward, left and up. */
const FLY: Record<string, [number, number, number]> = {
  KeyW: [1, 0, 0], KeyS: [-1, 0, 0], KeyA: [0, 1, 0], KeyD: [0, -1, 0], KeyE: [0, 0, 1], KeyQ: [0, 0, -1],
};

/**
 * Moves the camera of the 3D view: orbits about a target, pans, zooms, looks around and flies. It draws nothing itself and calls
 * `onChange` after each movement.
 */
export class Navigation {
  isEnabled = true;
  private up: UpAxis = "z";
  private readonly target = new Vector3();
  private distance = 5;
  private azimuth = 0;
  private elevation = 0.4;
  private readonly keys = new Set<string>();
  private isFast = false;
  private lastTime = 0;

  constructor(private readonly camera: PerspectiveCamera, private readonly element: HTMLElement, private readonly onChange: () => void) {
    element.addEventListener("pointerdown", (event) => this.grab(event));
    element.addEventListener("wheel", (event) => this.zoom(event), { passive: false });
    element.addEventListener("contextmenu", (event) => event.preventDefault());
    element.addEventListener("keydown", (event) => this.press(event));
    element.addEventListener("keyup", (event) => this.keys.delete(event.code));
    element.addEventListener("blur", () => this.keys.clear());
  }

  /** Looks at a target from a direction of the world. */
  look(up: UpAxis, target: Vector3, from: Vector3): void {
    this.up = up;
    this.camera.up.copy(this.world(0, 0, 1));
    this.target.copy(target);
    const offset = from.clone().sub(target);
    this.distance = Math.max(offset.length(), 0.05);
    const [x, y, z] = this.local(offset.normalize());
    this.azimuth = Math.atan2(y, x);
    this.elevation = Math.asin(Math.max(-1, Math.min(1, z)));
    this.apply();
  }

  /** Looks along a body's x axis from where it is. */
  lookAlong(pose: Pose): void {
    const position = new Vector3(...pose.position);
    const forward = new Vector3(...rotate(pose.quaternion, [1, 0, 0]));
    this.look(this.up, position.clone().addScaledVector(forward, 2), position);
  }

  /** Moves the target to a point and keeps the direction. */
  focus(point: Vector3, distance: number): void {
    this.target.copy(point);
    this.distance = distance;
    this.apply();
  }

  /** Converts a vector whose z axis is up to the world. */
  private world(x: number, y: number, z: number): Vector3 {
    return this.up === "z" ? new Vector3(x, y, z) : new Vector3(x, z, -y);
  }

  private local({ x, y, z }: Vector3): [number, number, number] {
    return this.up === "z" ? [x, y, z] : [x, -z, y];
  }

  /** The unit vector from the target to the camera. */
  private outward(): Vector3 {
    const level = Math.cos(this.elevation);
    return this.world(level * Math.cos(this.azimuth), level * Math.sin(this.azimuth), Math.sin(this.elevation));
  }

  private apply(): void {
    this.elevation = Math.max(-MAX_ELEVATION, Math.min(MAX_ELEVATION, this.elevation));
    this.camera.position.copy(this.target).addScaledVector(this.outward(), this.distance);
    this.camera.lookAt(this.target);
    this.camera.updateMatrixWorld();
    this.onChange();
  }

  private grab(event: PointerEvent): void {
    if (!this.isEnabled) return;
    this.element.focus({ preventScroll: true });
    const isPan = event.button !== 0 || event.shiftKey;
    const isLook = event.ctrlKey || event.altKey;
    let [x, y] = [event.clientX, event.clientY];
    const move = (next: PointerEvent) => {
      if (!this.isEnabled) return;
      const [right, down] = [next.clientX - x, next.clientY - y];
      [x, y] = [next.clientX, next.clientY];
      if (isPan) this.pan(right, down);
      else if (isLook) this.turnHead(right, down);
      else this.orbit(right, down);
    };
    const end = () => {
      removeEventListener("pointermove", move);
      removeEventListener("pointerup", end);
      removeEventListener("pointercancel", end);
    };
    addEventListener("pointermove", move);
    addEventListener("pointerup", end);
    addEventListener("pointercancel", end);
  }

  private orbit(right: number, down: number): void {
    this.azimuth -= right * TURN_PER_PIXEL;
    this.elevation += down * TURN_PER_PIXEL;
    this.apply();
  }

  /** Turns about the camera instead of the target. */
  private turnHead(right: number, down: number): void {
    const eye = this.camera.position.clone();
    this.azimuth -= right * TURN_PER_PIXEL * 0.5;
    this.elevation = Math.max(-MAX_ELEVATION, Math.min(MAX_ELEVATION, this.elevation + down * TURN_PER_PIXEL * 0.5));
    this.target.copy(eye).addScaledVector(this.outward(), -this.distance);
    this.apply();
  }

  private pan(right: number, down: number): void {
    const perPixel = (2 * this.distance * Math.tan((this.camera.fov * Math.PI) / 360)) / this.element.clientHeight;
    const side = new Vector3().setFromMatrixColumn(this.camera.matrixWorld, 0);
    const top = new Vector3().setFromMatrixColumn(this.camera.matrixWorld, 1);
    this.target.addScaledVector(side, -right * perPixel).addScaledVector(top, down * perPixel);
    this.apply();
  }

  private zoom(event: WheelEvent): void {
    event.preventDefault();
    const lines = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 30 : 1;
    this.distance = Math.min(500, Math.max(0.05, this.distance * ZOOM_PER_STEP ** (event.deltaY * lines)));
    this.apply();
  }

  private press(event: KeyboardEvent): void {
    this.isFast = event.shiftKey;
    if (event.ctrlKey || event.metaKey || event.altKey || !(event.code in FLY)) return;
    event.preventDefault();
    const wasStill = this.keys.size === 0;
    this.keys.add(event.code);
    if (!wasStill) return;
    this.lastTime = performance.now();
    requestAnimationFrame(() => this.fly());
  }

  /** Moves camera and target while keys are held. */
  private fly(): void {
    if (this.keys.size === 0) return;
    const now = performance.now();
    const seconds = Math.min((now - this.lastTime) / 1000, 0.1);
    this.lastTime = now;
    const speed = Math.max(0.4, this.distance * 0.6) * (this.isFast ? 3 : 1) * seconds;
    const forward = this.outward().negate();
    const side = new Vector3().setFromMatrixColumn(this.camera.matrixWorld, 0);
    for (const key of this.keys) {
      const [ahead, left, rise] = FLY[key] ?? [0, 0, 0];
      this.target.addScaledVector(forward, ahead * speed).addScaledVector(side, -left * speed).add(this.world(0, 0, rise * speed));
    }
    this.apply();
    requestAnimationFrame(() => this.fly());
  }
}
