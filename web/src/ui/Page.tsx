import { useEffect, useRef, useState } from "preact/hooks";
import { DEFAULT_DISPLAY, type Display, SIDE_WIDTHS } from "../state/display";
import { openFiles } from "../studio/files";
import { useDarkSystem } from "../util/scheme";
import { useStore } from "../util/store";
import { useApp } from "./context";
import { Help } from "./Help";
import { Images } from "./Images";
import { Inspect } from "./Inspect";
import { Notices } from "./Notices";
import { OakList } from "./OakList";
import { Place } from "./Place";
import { PoseFields } from "./PoseFields";
import { Robot } from "./Robot";
import { listenForKeys } from "./shortcuts";
import { TimelineBar } from "./TimelineBar";
import { Tooltip } from "./Tooltip";
import { TopBar } from "./TopBar";
import { Tune } from "./Tune";
import { UnitsDialog } from "./UnitsDialog";
import { View } from "./View";

/** The whole page. */
export function Page() {
  const app = useApp();
  const { studio } = app;
  const display = useStore(studio.display);
  const [isHelp, setHelp] = useState(false);
  const isDarkSystem = useDarkSystem();
  useEffect(() => listenForKeys(app, () => setHelp(true)), []);
  useEffect(() => {
    const { theme } = display;
    if (theme === "auto") delete document.documentElement.dataset.theme;
    else document.documentElement.dataset.theme = theme;
    app.view.get()?.paintBackground();
    app.repaint.update((count) => count + 1);
  }, [display.theme, isDarkSystem]);
  return (
    <div class="page" style={{ "--left": sideWidth(display, "left"), "--right": sideWidth(display, "right") }}>
      <TopBar onHelp={() => setHelp(true)} />
      {display.showLeft && (
        <aside class="side left" aria-label="Controls">
          <OakList />
          <PoseFields />
          <Robot />
          <Tune />
        </aside>
      )}
      <Middle />
      {display.showRight && <RightSide />}
      <Notices />
      <DropTarget />
      <Tooltip />
      <UnitsDialog />
      {isHelp && <Help onClose={() => setHelp(false)} />}
    </div>
  );
}

function RightSide() {
  const { studio } = useApp();
  const tab = useStore(studio.tab);
  const tabs = [["inspect", "Understand"], ["place", "Place"]] as const;
  const key = (event: KeyboardEvent) => {
    if (event.key !== "ArrowLeft" && event.key !== "ArrowRight") return;
    const next = tab === "inspect" ? "place" : "inspect";
    studio.tab.set(next);
    document.getElementById(`tab-${next}`)?.focus();
  };
  return (
    <aside class="side right" aria-label="Numbers">
      <div class="tabs" role="tablist" onKeyDown={key}>
        {tabs.map(([id, title]) => (
          <button key={id} type="button" role="tab" id={`tab-${id}`} aria-selected={tab === id} tabIndex={tab === id ? 0 : -1} aria-controls="tab-panel" data-testid={`tab-${id}`} onClick={() => studio.tab.set(id)}>{title}</button>
        ))}
      </div>
      <div role="tabpanel" id="tab-panel" aria-labelledby={`tab-${tab}`}>{tab === "inspect" ? <Inspect /> : <Place />}</div>
    </aside>
  );
}

/** The width of a side bar. The default leaves more room for the images in a narrow window. */
function sideWidth({ showLeft, showRight, leftWidth, rightWidth }: Display, side: "left" | "right"): string {
  const [isShown, width, usual] = side === "left" ? [showLeft, leftWidth, DEFAULT_DISPLAY.leftWidth] : [showRight, rightWidth, DEFAULT_DISPLAY.rightWidth];
  return isShown ? `min(${width}rem, ${width === usual ? 24 : 35}vw)` : "0px";
}

/** The edge of a side bar, which can be moved; a double click restores the width. */
function SideEdge({ side }: { side: "left" | "right" }) {
  const { studio } = useApp();
  const name = side === "left" ? "leftWidth" : "rightWidth";
  const width = useStore(studio.display)[name];
  const [least, most] = SIDE_WIDTHS;
  const set = (next: number) => studio.show({ [name]: Math.max(least, Math.min(most, next)) });
  const outwards = side === "left" ? 1 : -1;
  const grab = (event: PointerEvent) => {
    event.preventDefault();
    const font = Number.parseFloat(getComputedStyle(document.documentElement).fontSize);
    const start = event.clientX;
    const move = (next: PointerEvent) => set(width + (outwards * (next.clientX - start)) / font);
    addEventListener("pointermove", move);
    addEventListener("pointerup", () => removeEventListener("pointermove", move), { once: true });
  };
  const key = (event: KeyboardEvent) => {
    const by = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
    if (by === undefined) return;
    event.preventDefault();
    set(width + outwards * by);
  };
  return (
    <div
      class={`side-edge ${side}`}
      role="separator"
      aria-orientation="vertical"
      aria-label={side === "left" ? "Width of the controls" : "Width of the numbers"}
      aria-valuenow={Math.round(width)}
      aria-valuemin={least}
      aria-valuemax={most}
      tabIndex={0}
      data-testid={`edge-${side}`}
      onPointerDown={grab}
      onDblClick={() => set(DEFAULT_DISPLAY[name])}
      onKeyDown={key}
    />
  );
}

/** The 3D view above the images, with a bar between them that can be moved. */
function Middle() {
  const { studio } = useApp();
  const { split, showLeft, showRight } = useStore(studio.display);
  const element = useRef<HTMLElement>(null);
  const set = (split: number) => studio.show({ split: Math.max(0.12, Math.min(0.88, split)) });
  const grab = (event: PointerEvent) => {
    event.preventDefault();
    const box = element.current?.getBoundingClientRect();
    if (!box) return;
    const move = (next: PointerEvent) => set((next.clientY - box.top) / box.height);
    const end = () => removeEventListener("pointermove", move);
    addEventListener("pointermove", move);
    addEventListener("pointerup", end, { once: true });
  };
  const key = (event: KeyboardEvent) => {
    const by = { ArrowUp: -0.03, ArrowDown: 0.03 }[event.key];
    if (by === undefined) return;
    event.preventDefault();
    set(split + by);
  };
  return (
    <main class="middle" ref={element} style={{ gridTemplateRows: `minmax(0, ${split}fr) 7px minmax(0, ${1 - split}fr) auto` }}>
      <View />
      <div
        class="splitter"
        role="separator"
        aria-orientation="horizontal"
        aria-label="Share of the 3D view"
        aria-valuenow={Math.round(split * 100)}
        aria-valuemin={12}
        aria-valuemax={88}
        tabIndex={0}
        onPointerDown={grab}
        onKeyDown={key}
      />
      <Images />
      <TimelineBar />
      {showLeft && <SideEdge side="left" />}
      {showRight && <SideEdge side="right" />}
    </main>
  );
}

/** Takes files that are dropped anywhere on the page. */
function DropTarget() {
  const { studio } = useApp();
  const [isOver, setOver] = useState(false);
  useEffect(() => {
    const hasFiles = (event: DragEvent) => event.dataTransfer?.types.includes("Files") ?? false;
    const over = (event: DragEvent) => {
      if (!hasFiles(event)) return;
      event.preventDefault();
      setOver(true);
    };
    const leave = (event: DragEvent) => event.relatedTarget === null && setOver(false);
    const drop = (event: DragEvent) => {
      if (!hasFiles(event)) return;
      event.preventDefault();
      setOver(false);
      void openFiles(studio, [...(event.dataTransfer?.files ?? [])]);
    };
    addEventListener("dragover", over);
    addEventListener("dragleave", leave);
    addEventListener("drop", drop);
    return () => {
      removeEventListener("dragover", over);
      removeEventListener("dragleave", leave);
      removeEventListener("drop", drop);
    };
  }, [studio]);
  if (!isOver) return null;
  return <div class="drop"><p>Drop a scene, a robot, its postures, a calibration, a trajectory or a session</p><span>It stays on this computer, and is forgotten when the server ends.</span></div>;
}
