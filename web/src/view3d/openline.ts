import { BufferGeometry, Float32BufferAttribute, Line, LineBasicMaterial, Points, PointsMaterial, type Scene } from "three";
import type { Vec3 } from "../protocol";

/** A line through marked points, which nothing hides. */
export class OpenLine {
  private readonly geometry = new BufferGeometry();
  private readonly line: Line;
  private readonly marks: Points;

  /** `size` is the size of the marks in pixels. */
  constructor(scene: Scene, color: string, size: number) {
    const look = { color, depthTest: false, transparent: true };
    this.line = new Line(this.geometry, new LineBasicMaterial(look));
    this.marks = new Points(this.geometry, new PointsMaterial({ ...look, size, sizeAttenuation: false }));
    for (const object of [this.line, this.marks]) {
      object.frustumCulled = false;
      object.renderOrder = 11;
      scene.add(object);
    }
    this.set([]);
  }

  set(points: readonly Vec3[]): void {
    // The buffers of a geometry keep their size.
    this.geometry.dispose();
    this.geometry.setAttribute("position", new Float32BufferAttribute(points.flat(), 3));
    this.line.visible = points.length > 1;
    this.marks.visible = points.length > 0;
  }
}
