import { api } from "../net/api";
import type { Pose, SceneInfo } from "../protocol";
import type { Oak, StudioDocument } from "../state/document";
import { multiply, normalise, type Quaternion, rotate } from "../util/pose";
import type { Studio } from "./studio";

/** Returns the id of the scene in any posture of its robot: `first` of `first~0.5,1.2`. */
export function unposed(scene: string): string {
  return scene.split("~", 1)[0] ?? scene;
}

/** Moves the joints of the robot in the scene, and the OAKs that it carries. */
export class RobotMover {
  private wanted: number[] | null = null;
  private isBusy = false;

  constructor(private readonly studio: Studio) {}

  /** Whether the robot is where it was moved last. */
  get isIdle(): boolean {
    return !this.isBusy;
  }

  /** Moves a joint, by its index. Of positions that come faster than the server answers, the last one counts. */
  move(joint: number, position: number): void {
    const robot = this.studio.scene.get()?.robot;
    if (!robot) return;
    const positions = this.wanted ?? robot.joints.map((one) => one.position);
    this.wanted = positions.map((own, i) => (i === joint ? position : own));
    void this.follow();
  }

  /** Moves all joints. */
  moveAll(positions: readonly number[]): void {
    this.wanted = [...positions];
    void this.follow();
  }

  /** Moves all joints to where they are when the scene is opened. */
  rest(): void {
    void this.show(unposed(this.studio.document.get().scene));
  }

  /** Mounts an OAK on a link, which it then follows, or releases it. It stays where it is. */
  mount(oak: string, link: string | null): void {
    this.studio.document.commit("mount", (document) => ({
      ...document, oaks: document.oaks.map((one) => (one.key === oak ? { ...one, mount: link } : one)),
    }));
  }

  /** Puts an OAK onto the link that carries it: to its origin, looking along the link's x axis. */
  toLink(): void {
    const { document, scene } = this.studio;
    const { oaks, selected } = document.get();
    const mount = oaks.find(({ key }) => key === selected)?.mount;
    const link = scene.get()?.robot?.links.find(({ name }) => name === mount);
    if (link) this.studio.change("pose", (state) => ({ ...state, pose: link.pose }));
  }

  private async follow(): Promise<void> {
    if (this.isBusy) return;
    this.isBusy = true;
    try {
      while (this.wanted) {
        const scene = `${unposed(this.studio.document.get().scene)}~${this.wanted.join(",")}`;
        this.wanted = null;
        await this.show(scene);
      }
    } finally {
      this.isBusy = false;
    }
  }

  private async show(id: string): Promise<void> {
    const { studio } = this;
    try {
      const info = await api.scene(id);
      const before = studio.scene.get();
      // The scene may have been replaced meanwhile.
      if (!before || unposed(studio.document.get().scene) !== unposed(id)) return;
      studio.scene.set(info);
      studio.document.commit("posture", (document) => carried(document, before, info));
    } catch (error) {
      studio.report("The robot cannot be moved", error);
    }
  }
}

/** The document with another posture of its robot: what a link carries moves with it. */
export function carried(document: StudioDocument, before: SceneInfo, after: SceneInfo): StudioDocument {
  const move = (oak: Oak): Oak => {
    const [from, to] = [before, after].map((info) => info.robot?.links.find(({ name }) => name === oak.mount)?.pose);
    if (!from || !to) return oak;
    return { ...oak, state: { ...oak.state, pose: compose(to, compose(inverse(from), oak.state.pose)) } };
  };
  return { ...document, scene: after.id, oaks: document.oaks.map(move) };
}

/** Returns the pose, in the world, of something with a pose in a frame. */
export function compose(frame: Pose, own: Pose): Pose {
  const [x, y, z] = rotate(frame.quaternion, own.position);
  const [px, py, pz] = frame.position;
  return { position: [px + x, py + y, pz + z], quaternion: normalise(multiply(frame.quaternion, own.quaternion)) };
}

export function inverse({ position: [x, y, z], quaternion: [qx, qy, qz, qw] }: Pose): Pose {
  const back: Quaternion = [-qx, -qy, -qz, qw];
  return { position: rotate(back, [-x, -y, -z]), quaternion: back };
}
