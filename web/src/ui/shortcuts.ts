import type { CloudSource } from "../state/display";
import { selectedOak } from "../state/document";
import { moved, turned } from "../util/pose";
import type { App } from "./context";

const STEP_M = 0.05;
const STEP_DEG = 2;
const CLOUDS: CloudSource[] = ["none", "truth", "measurement", "both"];

/** Handles the keys that work everywhere but in fields; `onHelp` shows the list of them. */
export function listenForKeys(app: App, onHelp: () => void): () => void {
  const listen = (event: KeyboardEvent) => {
    const { target } = event;
    const isTyping = target instanceof HTMLElement && target.matches("input:not([type=checkbox]), select, textarea");
    if (undo(app, event) || isTyping || document.querySelector("dialog[open]")) return;
    const isView = target instanceof HTMLCanvasElement;
    if ((isView && moveOak(app, event)) || plainKey(app, event, onHelp)) event.preventDefault();
  };
  addEventListener("keydown", listen);
  return () => removeEventListener("keydown", listen);
}

/** Undo works in fields, too: their text follows the state. */
function undo({ studio }: App, event: KeyboardEvent): boolean {
  if (!(event.ctrlKey || event.metaKey) || event.altKey) return false;
  const key = event.key.toLowerCase();
  if (key !== "z" && key !== "y") return false;
  event.preventDefault();
  if (document.activeElement instanceof HTMLInputElement) document.activeElement.blur();
  if (key === "y" || event.shiftKey) studio.document.redo();
  else studio.document.undo();
  return true;
}

function plainKey(app: App, event: KeyboardEvent, onHelp: () => void): boolean {
  if (event.ctrlKey || event.metaKey || event.altKey) return false;
  const { studio } = app;
  const view = app.view.get();
  const display = studio.display.get();
  const gizmo = (mode: "translate" | "rotate") => view?.gizmo.set(view.gizmo.get() === mode ? "none" : mode);
  const actions: Record<string, () => void> = {
    "?": onHelp,
    "1": () => studio.show({ showLeft: !display.showLeft }),
    "2": () => studio.show({ showRight: !display.showRight }),
    g: () => gizmo("translate"),
    r: () => gizmo("rotate"),
    p: () => studio.show({ cloud: CLOUDS[(CLOUDS.indexOf(display.cloud) + 1) % CLOUDS.length] ?? "none" }),
    c: () => view?.lookThrough(),
    f: () => view?.setRiding(!view.isRiding.get()),
    "[": () => selectNeighbour(app, -1),
    "]": () => selectNeighbour(app, 1),
    m: () => view?.ruler.set(view.ruler.get() ? null : []),
    " ": () => studio.timeline.toggle(),
    ",": () => studio.timeline.step(-1),
    ".": () => studio.timeline.step(1),
    Home: () => view?.home(),
    Escape: () => {
      studio.hover.set(null);
      studio.maximized.set(null);
      view?.isPicking.set(false);
      view?.ruler.set(null);
      view?.setRiding(false);
    },
  };
  // The space bar presses a button that has the focus.
  const isPressed = event.key === " " && event.target instanceof HTMLButtonElement;
  const action = isPressed ? undefined : actions[event.key];
  action?.();
  return action !== undefined;
}

function selectNeighbour({ studio }: App, by: number): void {
  const document = studio.document.get();
  const at = document.oaks.findIndex(({ key }) => key === document.selected);
  const next = document.oaks[(at + by + document.oaks.length) % document.oaks.length];
  if (next) studio.document.set({ ...document, selected: next.key });
}

/** Moves the selected OAK by arrow keys: forward, back, left and right as it looks. */
function moveOak({ studio }: App, event: KeyboardEvent): boolean {
  if (event.ctrlKey || event.metaKey || !selectedOak(studio.document.get())) return false;
  const up = studio.scene.get()?.up ?? "z";
  const step = STEP_M * (event.shiftKey ? 0.1 : 1);
  const angle = STEP_DEG * (event.shiftKey ? 0.1 : 1);
  const moves: Record<string, [number, number, number]> = {
    ArrowUp: [step, 0, 0], ArrowDown: [-step, 0, 0], ArrowLeft: [0, step, 0], ArrowRight: [0, -step, 0],
    PageUp: [0, 0, step], PageDown: [0, 0, -step],
  };
  const turns: Record<string, { yaw?: number; pitch?: number }> = {
    ArrowUp: { pitch: -angle }, ArrowDown: { pitch: angle }, ArrowLeft: { yaw: angle }, ArrowRight: { yaw: -angle },
  };
  const [move, turn] = [moves[event.key], turns[event.key]];
  if (event.altKey ? !turn : !move) return false;
  studio.change("keys", (state) => ({ ...state, pose: event.altKey ? turned(state.pose, turn ?? {}, up) : moved(state.pose, move ?? [0, 0, 0], up) }));
  return true;
}
