import { type BufferGeometry, Matrix4, Quaternion, Vector3 } from "three";
import type { Pose, RobotInfo, SceneInfo } from "../protocol";

/** The vertices of a link, and where they are while the link is at its first pose. */
interface Part {
  link: number;
  vertices: number[];
  first: Float32Array;
}

/** The parts of a robot in the mesh of a scene: they move without another mesh. */
export class RobotParts {
  private readonly parts: Part[];
  private readonly inverses: Matrix4[];

  constructor(private readonly geometry: BufferGeometry, objects: Uint32Array, private readonly scene: SceneInfo, robot: RobotInfo) {
    this.inverses = robot.links.map(({ pose }) => matrix(pose).invert());
    const links = scene.objects.map(({ path }) => robot.links.findIndex((link) => path.startsWith(`${link.path}/`)));
    const byLink = new Map<number, Set<number>>();
    // Vertices are shared within an object only.
    geometry.getIndex()?.array.forEach((vertex, i) => {
      const link = links[objects[Math.floor(i / 3)] ?? 0] ?? -1;
      if (link < 0) return;
      const known = byLink.get(link) ?? new Set();
      byLink.set(link, known.add(vertex));
    });
    const positions = geometry.getAttribute("position");
    this.parts = [...byLink].map(([link, set]) => ({ link, vertices: [...set] })).map(({ link, vertices }) => ({
      link,
      vertices,
      first: Float32Array.from(vertices.flatMap((vertex) => [positions.getX(vertex), positions.getY(vertex), positions.getZ(vertex)])),
    }));
  }

  /** Whether the parts are of this scene, in any posture. */
  isOf(info: SceneInfo): boolean {
    return info.robot?.links.length === this.scene.robot?.links.length && info.objects.length === this.scene.objects.length;
  }

  /** Moves the parts to where a robot's links are. */
  move(robot: RobotInfo): void {
    const positions = this.geometry.getAttribute("position");
    const point = new Vector3();
    for (const { link, vertices, first } of this.parts) {
      const [to, from] = [robot.links[link], this.inverses[link]];
      if (!to || !from) continue;
      const moved = matrix(to.pose).multiply(from);
      vertices.forEach((vertex, i) => {
        point.fromArray(first, i * 3).applyMatrix4(moved);
        positions.setXYZ(vertex, point.x, point.y, point.z);
      });
    }
    positions.needsUpdate = true;
    this.geometry.computeBoundingSphere();
  }
}

function matrix({ position, quaternion }: Pose): Matrix4 {
  return new Matrix4().compose(new Vector3(...position), new Quaternion(...quaternion), new Vector3(1, 1, 1));
}
