import { useEffect, useRef } from "preact/hooks";
import { SceneView } from "../studio/view";
import type { CloudColor, CloudSource } from "../state/display";
import type { Studio } from "../studio/studio";
import { save } from "../util/away";
import { decimal, length } from "../util/format";
import { useStore } from "../util/store";
import { Button, Select } from "./controls";
import { useApp } from "./context";
import { Start } from "./Start";

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
        {made && <RulerTool view={made} />}
        <Button icon="picture" label="Save a picture of this view (PNG)" onClick={() => made && void savePicture(studio, made)} testId="picture" />
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
      <div class="foot">
        {made && <Ruler view={made} />}
        {made && <Pointed view={made} />}
        {made && <Detail view={made} />}
        <Start />
      </div>
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

function RulerTool({ view }: { view: SceneView }) {
  const isOn = useStore(view.ruler) !== null;
  return <Button icon="ruler" label="Measure between two points (M)" isOn={isOn} onClick={() => view.ruler.set(isOn ? null : [])} testId="ruler" />;
}

async function savePicture(studio: Studio, view: SceneView): Promise<void> {
  const picture = await view.viewer.picture();
  if (picture) save("oaktwin-view.png", picture);
  else studio.notify("warning", "The browser could not make a picture of the view.");
}

/** The distance between the points of the ruler. */
function Ruler({ view }: { view: SceneView }) {
  const points = useStore(view.ruler);
  if (!points) return null;
  const [a, b] = points;
  if (!a || !b) return <div class="note-line" data-testid="distance">{a ? "Click the second point." : "Click two points of the scene. Escape ends."}</div>;
  const along = b.map((value, axis) => decimal(value - (a[axis] ?? 0), 3));
  return <div class="note-line" data-testid="distance"><b>{length(Math.hypot(...b.map((value, axis) => value - (a[axis] ?? 0))))}</b>{` (${along.join(", ")} m along x, y, z)`}</div>;
}

/** What is under the mouse. */
function Pointed({ view }: { view: SceneView }) {
  const { studio } = useApp();
  const pointed = useStore(view.pointed);
  const { oaks, selected } = useStore(studio.document);
  if (!pointed) return null;
  const model = oaks.find(({ key }) => key === selected)?.state.model ?? "";
  const at = pointed.point.map((metres) => decimal(metres, 3)).join(", ");
  const seen = pointed.isSeen ? "" : `, not in its view`;
  return <div class="note-line" data-testid="pointed">{`${pointed.object ?? ""} at ${at} m; ${length(pointed.distanceM)} from the ${model}${seen}`}</div>;
}

/** Says what is drawn of a large scene. */
function Detail({ view }: { view: SceneView }) {
  const detail = useStore(view.detail);
  const isPicking = useStore(view.isPicking);
  if (isPicking) return <div class="note-line">Click an object of the scene. Escape cancels.</div>;
  const isPointing = useStore(view.pointed) !== null;
  const isMeasuring = useStore(view.ruler) !== null;
  if (!detail || detail.shown >= detail.of || isPointing || isMeasuring) return null;
  return (
    <div class="note-line">
      {`This view draws ${detail.shown.toLocaleString("en")} of ${detail.of.toLocaleString("en")} triangles; the images use all. `}
      <button type="button" class="link" onClick={() => view.loadFullDetail()}>Draw all</button>
    </div>
  );
}
