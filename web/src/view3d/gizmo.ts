import { Object3D, type PerspectiveCamera, type Scene } from "three";
import { TransformControls } from "three/addons/controls/TransformControls.js";
import type { Pose } from "../protocol";
import type { Navigation } from "./navigation";

export type GizmoMode = "translate" | "rotate" | "none";

/** The handles that move and turn the selected OAK. */
export class Gizmo {
  private readonly controls: TransformControls;
  private readonly handle = new Object3D();

  constructor(
    camera: PerspectiveCamera,
    canvas: HTMLCanvasElement,
    scene: Scene,
    navigation: Navigation,
    onPose: (pose: Pose) => void,
    onChange: () => void,
  ) {
    this.controls = new TransformControls(camera, canvas);
    this.controls.setSize(0.7);
    scene.add(this.handle, this.controls.getHelper());
    this.controls.addEventListener("change", onChange);
    this.controls.addEventListener("dragging-changed", ({ value }) => {
      navigation.isEnabled = !value;
    });
    this.controls.addEventListener("objectChange", () => {
      const { x, y, z } = this.handle.position;
      const { x: qx, y: qy, z: qz, w: qw } = this.handle.quaternion;
      onPose({ position: [x, y, z], quaternion: [qx, qy, qz, qw] });
    });
  }

  /** Whether the pointer is on a handle or drags it. */
  get isActive(): boolean {
    return this.controls.dragging || this.controls.axis !== null;
  }

  set(mode: GizmoMode, pose: Pose | null): void {
    if (mode === "none" || !pose) {
      this.controls.detach();
      return;
    }
    this.controls.setMode(mode);
    // A tilted OAK still moves level and upright; it turns about its own axes.
    this.controls.setSpace(mode === "translate" ? "world" : "local");
    if (!this.controls.dragging) {
      this.handle.position.set(...pose.position);
      this.handle.quaternion.set(...pose.quaternion);
      this.handle.updateMatrixWorld();
    }
    if (this.controls.object !== this.handle) this.controls.attach(this.handle);
  }
}
