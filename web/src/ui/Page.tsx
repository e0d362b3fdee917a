import { useEffect, useRef, useState } from "preact/hooks";
import { openFiles } from "../studio/files";
import { useStore } from "../util/store";
import { useApp } from "./context";
import { Help } from "./Help";
import { Images } from "./Images";
import { Inspect } from "./Inspect";
import { Notices } from "./Notices";
import { OakList } from "./OakList";
import { Place } from "./Place";
import { PoseFields } from "./PoseFields";
import { listenForKeys } from "./shortcuts";
import { Tooltip } from "./Tooltip";
import { TopBar } from "./TopBar";
import { Tune } from "./Tune";
import { View } from "./View";

/** The whole page. */
export function Page() {
  const app = useApp();
  const { studio } = app;
  const display = useStore(studio.display);
  const [isHelp, setHelp] = useState(false);
  useEffect(() => listenForKeys(app, () => setHelp(true)), []);
  useEffect(() => {
    const { theme } = display;
    if (theme === "auto") delete document.documentElement.dataset.theme;
    else document.documentElement.dataset.theme = theme;
    app.view.get()?.paintBackground();
    app.repaint.update((count) => count + 1);
  }, [display.theme]);
  return (
    <div class={`page ${display.showLeft ? "" : "no-left"} ${display.showRight ? "" : "no-right"}`}>
      <TopBar onHelp={() => setHelp(true)} />
      {display.showLeft && (
        <aside class="side left" aria-label="Controls">
          <OakList />
          <PoseFields />
          <Tune />
        </aside>
      )}
      <Middle />
      {display.showRight && <RightSide />}
      <Notices />
      <DropTarget />
      <Tooltip />
      {isHelp && <Help onClose={() => setHelp(false)} />}
    </div>
  );
}

function RightSide() {
  const [tab, setTab] = useState<"inspect" | "place">("inspect");
  const tabs = [["inspect", "Understand"], ["place", "Place"]] as const;
  const key = (event: KeyboardEvent) => {
    if (event.key !== "ArrowLeft" && event.key !== "ArrowRight") return;
    const next = tab === "inspect" ? "place" : "inspect";
    setTab(next);
    document.getElementById(`tab-${next}`)?.focus();
  };
  return (
    <aside class="side right" aria-label="Numbers">
      <div class="tabs" role="tablist" onKeyDown={key}>
        {tabs.map(([id, title]) => (
          <button key={id} type="button" role="tab" id={`tab-${id}`} aria-selected={tab === id} tabIndex={tab === id ? 0 : -1} aria-controls="tab-panel" data-testid={`tab-${id}`} onClick={() => setTab(id)}>{title}</button>
        ))}
      </div>
      <div role="tabpanel" id="tab-panel" aria-labelledby={`tab-${tab}`}>{tab === "inspect" ? <Inspect /> : <Place />}</div>
    </aside>
  );
}

/** The 3D view above the images, with a bar between them that can be moved. */
function Middle() {
  const { studio } = useApp();
  const { split } = useStore(studio.display);
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
    <main class="middle" ref={element} style={{ gridTemplateRows: `minmax(0, ${split}fr) 7px minmax(0, ${1 - split}fr)` }}>
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
  return <div class="drop"><p>Drop a scene or a calibration</p><span>It is read, never stored, and stays on this computer.</span></div>;
}
