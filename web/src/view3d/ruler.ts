import { BufferGeometry, Float32BufferAttribute, Line, LineBasicMaterial, Points, PointsMaterial, type Scene } from "three";
import type { Vec3 } from "../protocol";

const COLOR = "#ffb000";

/** A straight line between two points, which nothing hides. */
export class RulerLine {
  private readonly geometry = new BufferGeometry().setAttribute("position", new Float32BufferAttribute(new Float32Array(6), 3));
  private readonly line = new Line(this.geometry, new LineBasicMaterial({ color: COLOR, depthTest: false, transparent: true }));
  private readonly ends = new Points(this.geometry, new PointsMaterial({ color: COLOR, size: 8, sizeAttenuation: false, depthTest: false, transparent: true }));

  constructor(scene: Scene) {
    for (const object of [this.line, this.ends]) {
      object.frustumCulled = false;
      object.renderOrder = 11;
      scene.add(object);
    }
    this.set([]);
  }

  /** Shows up to two points. */
  set(points: readonly Vec3[]): void {
    const positions = this.geometry.getAttribute("position");
    points.slice(0, 2).forEach((point, i) => positions.setXYZ(i, ...point));
    positions.needsUpdate = true;
    this.geometry.setDrawRange(0, Math.min(points.length, 2));
    this.line.visible = points.length >= 2;
    this.ends.visible = points.length > 0;
  }
}
