import { api } from "../net/api";
import type { MotionAnswer, MotionInfo, MotionRequest } from "../protocol";
import { selectedOak, sceneAt, type Target } from "../state/document";
import { Store } from "../util/store";
import { Known } from "./known";
import { compose, inverse, unposed } from "./robot";
import type { Studio } from "./studio";

/** The name of a list that was collected on the page. */
const COLLECTED = "postures.csv";

/** A result with what it was measured for. */
interface Measured {
  key: string;
  answer: MotionAnswer;
}

/** The list of postures of the scene's robot, and what the selected OAK measures of the region over them. */
export class Motion {
  readonly lists: Known<MotionInfo>;
  /** How many postures are done, of how many; null while nothing is measured. */
  readonly progress = new Store<[number, number] | null>(null);
  readonly measured = new Store<Measured | null>(null);
  readonly problem = new Store<string | null>(null);
  private running: AbortController | null = null;
  /** Changes of the list follow each other. */
  private changing: Promise<void> = Promise.resolve();

  constructor(private readonly studio: Studio) {
    this.lists = new Known(studio, "motion", api.motion);
  }

  /** Reads a file with postures of the scene's robot. */
  async open(file: File): Promise<MotionInfo> {
    const info = await api.openMotion(file, this.studio.document.get().scene);
    this.lists.learn(info);
    this.studio.document.commit("motion", (document) => ({ ...document, motion: info.id }));
    return info;
  }

  /** Adds the posture in which the robot is. */
  add(): void {
    const joints = this.studio.scene.get()?.robot?.joints;
    if (joints) this.change((postures) => [...postures, joints.map(({ position }) => position)]);
  }

  remove(index: number): void {
    this.change((postures) => postures.filter((_, i) => i !== index));
  }

  clear(): void {
    this.studio.document.commit("motion", (document) => ({ ...document, motion: null }));
  }

  /** Moves the robot to a posture. */
  show(index: number): void {
    const posture = this.lists.current()?.postures[index];
    if (posture) this.studio.robot.moveAll(posture);
  }

  /** The list as a file that `--joints` reads. */
  file(postures = this.lists.current()?.postures ?? []): File {
    const names = (this.studio.scene.get()?.robot?.joints ?? []).map(({ name }) => name);
    const cell = (name: string) => (/[",\n]/.test(name) || name !== name.trim() ? `"${name.replaceAll('"', '""')}"` : name);
    const lines = [names.map(cell), ...postures].map((line) => `${line.join(",")}\n`);
    return new File([lines.join("")], COLLECTED);
  }

  /** Returns what has to be measured now; null if there is no list. */
  request(region: Target, toleranceMm: number | null): MotionRequest | null {
    const document = this.studio.document.get();
    const [oak, motion] = [selectedOak(document), this.lists.current()];
    if (!oak || !motion) return null;
    return { scene: sceneAt(document), motion: motion.id, mount: oak.mount ?? null, state: oak.state, region, toleranceMm };
  }

  /** Identifies what is measured: the pose of an OAK on a link does not depend on the posture. */
  key(request: MotionRequest): string {
    const link = this.studio.scene.get()?.robot?.links.find(({ name }) => name === request.mount)?.pose;
    const { position, quaternion } = link ? compose(inverse(link), request.state.pose) : request.state.pose;
    const pose = [...position, ...quaternion].map((number) => Number(number.toFixed(6)) + 0);
    return JSON.stringify({ ...request, scene: unposed(request.scene), state: { ...request.state, pose } });
  }

  async measure(region: Target, toleranceMm: number | null): Promise<void> {
    const request = this.request(region, toleranceMm);
    if (!request || this.running) return;
    const key = this.key(request);
    const own = new AbortController();
    this.running = own;
    this.problem.set(null);
    this.measured.set(null);
    this.progress.set([0, this.lists.current()?.postures.length ?? 0]);
    try {
      const answer = await api.motionCoverage(request, own.signal, (done, of) => this.progress.set([done, of]));
      this.measured.set({ key, answer });
    } catch (error) {
      if (!own.signal.aborted) this.problem.set(error instanceof Error ? error.message : String(error));
    } finally {
      this.running = null;
      this.progress.set(null);
    }
  }

  cancel(): void {
    this.running?.abort();
  }

  private change(change: (postures: number[][]) => number[][]): void {
    this.changing = this.changing.then(async () => {
      try {
        const postures = change(this.lists.current()?.postures ?? []);
        if (postures.length === 0) this.clear();
        else await this.open(this.file(postures));
      } catch (error) {
        this.studio.report("The list of postures", error);
      }
    });
  }
}
