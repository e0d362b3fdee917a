import { api } from "../net/api";
import type { TrajectoryInfo } from "../protocol";
import type { StudioDocument } from "../state/document";
import { type Frames, framesOf } from "../state/timeline";
import { Store } from "../util/store";
import { Known } from "./known";
import type { Studio } from "./studio";

/** Moves OAKs along a trajectory and the scene through its animation. */
export class Timeline {
  readonly isPlaying = new Store(false);
  /** How much faster than real time it plays. */
  readonly speed = new Store(1);
  readonly trajectories: Known<TrajectoryInfo>;

  constructor(private readonly studio: Studio) {
    this.trajectories = new Known(studio, "trajectory", api.trajectory, alone);
  }

  frames(): Frames | null {
    return framesOf(this.studio.scene.get(), this.trajectories.current());
  }

  /** Moves the OAK along a trajectory, from its first pose. */
  use(info: TrajectoryInfo): void {
    this.trajectories.learn(info);
    this.isPlaying.set(false);
    this.studio.document.commit("trajectory", (document) => this.at({ ...document, trajectory: info.id }, 0));
  }

  /** Shows the scene as it was opened, without a trajectory; OAKs stay where they are. */
  leave(): void {
    this.isPlaying.set(false);
    this.studio.document.commit("trajectory", (document) => ({ ...alone(document), moment: null, trajectory: null }));
  }

  /** Goes to a frame. */
  go(frame: number): void {
    this.studio.document.commit("frame", (document) => this.at(document, frame));
  }

  /** Goes some frames on or back. */
  step(by: number): void {
    this.pause();
    this.go((this.studio.document.get().moment?.frame ?? 0) + by);
  }

  /** Plays from the current frame, or again from the first one. */
  play(): void {
    const frames = this.frames();
    if (!frames || this.isPlaying.get()) return;
    const current = this.studio.document.get().moment?.frame ?? 0;
    const isAtEnd = current >= frames.count - 1;
    this.isPlaying.set(true);
    if (isAtEnd) this.go(0);
    let seconds = frames.timeOf(isAtEnd ? 0 : current);
    let before = performance.now();
    const tick = (now: number) => {
      if (!this.isPlaying.get()) return;
      const playing = this.frames();
      if (!playing) return this.pause();
      seconds += (Math.max(now - before, 0) / 1000) * this.speed.get();
      before = now;
      const next = playing.frameAt(seconds);
      if (next !== this.studio.document.get().moment?.frame) this.go(next);
      if (next >= playing.count - 1) this.pause();
      else requestAnimationFrame(tick);
    };
    requestAnimationFrame(tick);
  }

  pause(): void {
    if (!this.isPlaying.get()) return;
    this.isPlaying.set(false);
    // At rest, a frame of an animation is one on its own.
    const { moment } = this.studio.document.get();
    if (moment) this.go(moment.frame);
  }

  toggle(): void {
    if (this.isPlaying.get()) this.pause();
    else this.play();
  }

  /** Returns a document at a frame, whose number decides about the noise of OAKs on a trajectory, and of all while it plays. */
  private at(document: StudioDocument, wanted: number): StudioDocument {
    const trajectory = this.trajectories.all.get().get(document.trajectory ?? "") ?? null;
    const frames = framesOf(this.studio.scene.get(), trajectory);
    if (!frames) return document;
    const frame = Math.min(Math.max(wanted, 0), frames.count - 1);
    const time = frames.codes ? frames.codes.first + frame * frames.codes.step : null;
    const pose = trajectory?.poses[frame];
    const isPlaying = this.isPlaying.get();
    const oaks = document.oaks.map((oak) => {
      const isMoved = pose !== undefined && (document.arePosesLinked || oak.key === document.selected);
      const number = isMoved || isPlaying ? frame : 0;
      return { ...oak, state: { ...oak.state, pose: isMoved ? pose : oak.state.pose, frame: number } };
    });
    return { ...document, oaks, moment: { frame, time } };
  }
}

/** Makes the frames of all OAKs frames on their own. */
function alone(document: StudioDocument): StudioDocument {
  return { ...document, oaks: document.oaks.map((oak) => ({ ...oak, state: { ...oak.state, frame: 0 } })) };
}
