import { useEffect, useRef } from "preact/hooks";
import { SceneView } from "../studio/view";
import type { CloudColor, CloudSource } from "../state/display";
import { useStore } from "../util/store";
import { Button, Select } from "./controls";
import { useApp } from "./context";

const CLOUDS: { value: CloudSource; title: string }[] = [
  { value: "none", title: "No points" },
  { value: "truth", title: "True points" },
  { value: "measurement", title: "Measured points" },
  { value: "both", title: "True and measured" },
];
const CLOUD_COLORS: { value: CloudColor; title: string }[] = [
  { value: "error", title: "by error" },
  { value: "depth", title: "by depth" },
  { value: "reason", title: "by reason" },
  { value: "oak", title: "by OAK" },
];

/** The 3D view with its tools. */
export function View() {
  const app = useApp();
  const { studio, view } = app;
  const canvas = useRef<HTMLCanvasElement>(null);
  useEffect(() => {
    if (!canvas.current) return;
    const made = new SceneView(studio, canvas.current);
    view.set(made);
    return () => {
      view.set(null);
      made.viewer.close();
    };
  }, []);
  return (
    <section class="view" aria-label="3D view">
      <canvas
        ref={canvas}
        tabIndex={0}
        data-testid="view"
        aria-label="3D view of the scene. W, A, S, D, Q and E fly; arrow keys move the OAK; question mark lists all keys."
      />
      <Tools />
    </section>
  );
}

function Tools() {
  const { studio, view } = useApp();
  const made = useStore(view);
  const display = useStore(studio.display);
  const { cloud, cloudColor } = display;
  return (
    <>
      <div class="tools top" role="toolbar" aria-label="Tools of the 3D view">
        {made && <GizmoTools view={made} />}
        {made && <RideTool view={made} />}
        <Button icon="home" label="Look at the OAK (Home)" onClick={() => made?.home()} />
      </div>
      <div class="tools layers" role="toolbar" aria-label="What the 3D view shows">
        <Button label="Scene" class="chip" isOn={display.showScene} onClick={() => studio.show({ showScene: !display.showScene })} />
        <Button label="Roof" class="chip" tip="What is above the OAK, such as a ceiling" isOn={display.showRoof} onClick={() => studio.show({ showRoof: !display.showRoof })} />
        <Button label="Cameras" class="chip" tip="The fields of view of the cameras" isOn={display.showCameras} onClick={() => studio.show({ showCameras: !display.showCameras })} />
        <Button label="Ranges" class="chip" tip="The minimum (red), ideal (green) and maximum (orange) distance of the depth sensor" isOn={display.showRanges} onClick={() => studio.show({ showRanges: !display.showRanges })} />
        <Button label="Grid" class="chip" tip="Squares of one metre" isOn={display.showGrid} onClick={() => studio.show({ showGrid: !display.showGrid })} />
        <Select label="Point cloud" isLabelled={false} value={cloud} options={CLOUDS} onChange={(cloud) => studio.show({ cloud })} testId="cloud" />
        {cloud !== "none" && (
          <Select label="Colour of the points" isLabelled={false} value={cloudColor} options={CLOUD_COLORS} onChange={(cloudColor) => studio.show({ cloudColor })} />
        )}
      </div>
      {made && <Detail view={made} />}
    </>
  );
}

function GizmoTools({ view }: { view: SceneView }) {
  const mode = useStore(view.gizmo);
  const toggle = (next: "translate" | "rotate") => view.gizmo.set(mode === next ? "none" : next);
  return (
    <>
      <Button icon="move" label="Move the OAK (G)" isOn={mode === "translate"} onClick={() => toggle("translate")} />
      <Button icon="turn" label="Turn the OAK (R)" isOn={mode === "rotate"} onClick={() => toggle("rotate")} />
    </>
  );
}

function RideTool({ view }: { view: SceneView }) {
  const isRiding = useStore(view.isRiding);
  return <Button icon="camera" label="Fly the OAK: it moves with the view (F)" isOn={isRiding} onClick={() => view.setRiding(!isRiding)} />;
}

/** Says what is drawn of a large scene. */
function Detail({ view }: { view: SceneView }) {
  const detail = useStore(view.detail);
  const isPicking = useStore(view.isPicking);
  if (isPicking) return <div class="note-line">Click an object of the scene. Escape cancels.</div>;
  if (!detail || detail.shown >= detail.of) return null;
  return (
    <div class="note-line">
      {`This view draws ${detail.shown.toLocaleString("en")} of ${detail.of.toLocaleString("en")} triangles; the images use all. `}
      <button type="button" class="link" onClick={() => view.loadFullDetail()}>Draw all</button>
    </div>
  );
}
