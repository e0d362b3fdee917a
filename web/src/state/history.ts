import { Store } from "../util/store";

/** How long changes with the same tag count as one, ms. */
const SAME_GESTURE = 1000;

/** The number of steps that can be undone. */
const MAX_STEPS = 200;

/** A value with undo and redo. */
export class History<T> extends Store<T> {
  private past: T[] = [];
  private future: T[] = [];
  private lastTag = "";
  private lastTime = 0;

  /**
   * Changes the value. Changes with the same tag in quick succession are one step: a drag of a slider is undone at once.
   */
  commit(tag: string, change: (value: T) => T): void {
    const before = this.get();
    const after = change(before);
    if (Object.is(before, after)) return;
    const now = performance.now();
    const continues = tag === this.lastTag && now - this.lastTime < SAME_GESTURE;
    if (!continues) {
      this.past.push(before);
      if (this.past.length > MAX_STEPS) this.past.shift();
    }
    this.lastTag = tag;
    this.lastTime = now;
    this.future = [];
    this.set(after);
  }

  /** Replaces the value without a step, for values that were not there before. */
  reset(value: T): void {
    this.past = [];
    this.future = [];
    this.lastTag = "";
    this.set(value);
  }

  undo(): void {
    this.step(this.past, this.future);
  }

  redo(): void {
    this.step(this.future, this.past);
  }

  get canUndo(): boolean {
    return this.past.length > 0;
  }

  get canRedo(): boolean {
    return this.future.length > 0;
  }

  private step(from: T[], to: T[]): void {
    const value = from.pop();
    if (value === undefined) return;
    to.push(this.get());
    this.lastTag = "";
    this.set(value);
  }
}
