import { useEffect, useMemo, useRef, useState } from "preact/hooks";
import { css, outcomeColor } from "../gpu/colormaps";
import { api } from "../net/api";
import type { CoverageAnswer, OakState, SceneInfo, Vec3 } from "../protocol";
import { choosable, type Oak, type Target, sceneAt } from "../state/document";
import { type SceneView, targetBounds } from "../studio/view";
import { bareMillimetres, bareShare, NONE, words } from "../util/format";
import { useStore } from "../util/store";
import { Button, Check, NumberField, Section } from "./controls";
import { useApp } from "./context";
import { ColumnName } from "./ColumnName";
import { Motion } from "./Motion";
import { Report } from "./Report";
import { Sweep } from "./Sweep";

/** Which share of a region the OAKs measure, and which poses measure more. */
export function Place() {
  const { studio } = useApp();
  const { target } = useStore(studio.document);
  const { toleranceMm: tolerance } = useStore(studio.display);
  return (
    <>
      <Region target={target} />
      {target && <Coverage target={target} tolerance={tolerance} />}
      {target && <Sweep target={target} tolerance={tolerance} />}
      <Motion target={target} tolerance={tolerance} />
      {target && <Report target={target} tolerance={tolerance} />}
    </>
  );
}

function Region({ target }: { target: Target | null }) {
  const { studio, view } = useApp();
  const scene = useStore(studio.scene);
  const set = (target: Target | null) => studio.document.commit("target", (document) => ({ ...document, target }));
  const bounds = targetBounds(target, scene);
  const paths = useMemo(() => choosable(scene?.objects.map(({ path }) => path) ?? []), [scene]);
  const toBox = () => {
    const [minimum, maximum] = bounds ?? middle(scene);
    set({ minimum, maximum });
  };
  return (
    <Section title="Region" testId="region">
      <p class="hint">Which part of the scene must be measured? Choose an object, or a box.</p>
      <label class="field">
        <span class="sr-only">Object</span>
        <select
          data-testid="target"
          value={target && "object" in target ? target.object : ""}
          onChange={(event) => set(event.currentTarget.value ? { object: event.currentTarget.value } : null)}
        >
          <option value="">{target && "minimum" in target ? "A box" : "Choose an object…"}</option>
          {paths.map((path) => <option key={path} value={path} selected={target !== null && "object" in target && target.object === path}>{path}</option>)}
        </select>
      </label>
      <div class="row">
        <Button label="Click an object" tip="The next click in the 3D view chooses the object" onClick={() => view.get()?.isPicking.set(true)} />
        <Button label="Box" tip="A box in the world, at first around the chosen object" isOn={target !== null && "minimum" in target} onClick={toBox} />
        {target && <Button label="Clear" class="text" onClick={() => set(null)} />}
      </div>
      {target && "minimum" in target && <p class="hint">Drag the handles in the 3D view: a square moves a face, the ball the box (with Shift up and down).</p>}
      {target && "minimum" in target && <BoxFields box={target} onChange={set} />}
    </Section>
  );
}

/** A box in the middle of a scene, half as wide as it. */
function middle(scene: SceneInfo | null): [Vec3, Vec3] {
  if (!scene) return [[-1, -1, 0], [1, 1, 1]];
  const [low, high] = scene.bounds;
  const up = scene.up === "z" ? 2 : 1;
  const at = (axis: number, share: number) => Number(((low[axis] ?? 0) + ((high[axis] ?? 0) - (low[axis] ?? 0)) * share).toFixed(3));
  const corner = (level: number, height: number) => [0, 1, 2].map((axis) => at(axis, axis === up ? height : level)) as Vec3;
  return [corner(0.25, 0), corner(0.75, 0.5)];
}

function BoxFields({ box, onChange }: { box: { minimum: Vec3; maximum: Vec3 }; onChange: (box: Target) => void }) {
  const put = (end: "minimum" | "maximum", axis: number, value: number) => {
    const corner: Vec3 = [...box[end]];
    corner[axis] = value;
    onChange({ ...box, [end]: corner });
  };
  return (
    <div class="triple">
      {(["minimum", "maximum"] as const).flatMap((end) => ["X", "Y", "Z"].map((label, axis) => (
        <NumberField
          key={end + label}
          label={`${label} ${end === "minimum" ? "from" : "to"}`}
          value={box[end][axis] ?? 0}
          onChange={(value) => put(end, axis, value)}
          step={0.1}
          digits={3}
          unit="m"
          {...(end === "minimum" ? { maximum: box.maximum[axis] ?? 0 } : { minimum: box.minimum[axis] ?? 0 })}
        />
      )))}
    </div>
  );
}

/** How long the OAKs must not move before their coverage is computed, ms. */
const DELAY = 400;

/** A coverage, and what it was computed for. */
interface Computed {
  answer: CoverageAnswer | null;
  error: string | null;
  key: string;
}

/** Computes the coverage of states; computes again when they change. */
function useCoverage(scene: string, states: OakState[], target: Target, toleranceMm: number | null): Computed & { isOld: boolean } {
  const { studio } = useApp();
  const [result, setResult] = useState<Computed>({ answer: null, error: null, key: "" });
  const key = JSON.stringify([scene, states, target, toleranceMm]);
  const latest = useRef(key);
  latest.current = key;
  useEffect(() => {
    const running = new AbortController();
    const timer = setTimeout(() => {
      api.coverage({ scene, states, region: target, toleranceMm }, running.signal).then(
        (answer) => latest.current === key && setResult({ answer, error: null, key }),
        (error: unknown) => {
          if (!running.signal.aborted) setResult({ answer: null, error: error instanceof Error ? error.message : String(error), key });
        },
      );
    }, DELAY);
    return () => {
      clearTimeout(timer);
      running.abort();
    };
  }, [key, studio]);
  return { ...result, isOld: result.key !== key };
}

/** What each OAK measures of the region now. */
function Coverage({ target, tolerance }: { target: Target; tolerance: number | null }) {
  const { studio } = useApp();
  const document = useStore(studio.document);
  const { oaks } = document;
  const shown = oaks.filter((oak) => !oak.isHidden && studio.hasDepth(oak.state));
  const { answer, error, isOld } = useCoverage(sceneAt(document), shown.map(({ state }) => state), target, tolerance);
  return (
    <Section title="Coverage" testId="coverage">
      <Tolerance value={tolerance} />
      {error && <p class="problem" role="alert">{error}</p>}
      {!answer && !error && <p class="hint">Computing…</p>}
      {answer && <CoverageTable oaks={shown} all={oaks} answer={answer} isOld={isOld} />}
      <Paint />
    </Section>
  );
}

/** The largest error of a point that counts as measured. */
function Tolerance({ value }: { value: number | null }) {
  const { studio } = useApp();
  return (
    <div class="row">
      <Check
        label="Count only errors up to"
        tip="A point with a larger error counts as not measured"
        isOn={value !== null}
        onChange={(isOn) => studio.show({ toleranceMm: isOn ? 20 : null })}
      />
      {value !== null && (
        <NumberField label="Tolerance" isLabelled={false} unit="mm" value={value} step={1} digits={1} minimum={0.1} maximum={10000} onChange={(toleranceMm) => studio.show({ toleranceMm })} />
      )}
    </div>
  );
}

/** Whether the surface in the 3D view has the colours of the table. */
function Paint() {
  const { studio, view } = useApp();
  const { paintsCoverage } = useStore(studio.display);
  const made = useStore(view);
  return (
    <>
      <Check
        label="Paint the surface"
        tip="The 3D view shows with the colours of the table what the selected OAK measures of the surface"
        isOn={paintsCoverage}
        onChange={(paintsCoverage) => studio.show({ paintsCoverage })}
      />
      {made && <PaintProblem view={made} />}
    </>
  );
}

function PaintProblem({ view }: { view: SceneView }) {
  const { error } = useStore(view.painting);
  return error && <p class="problem" role="alert">{error}</p>;
}

function CoverageTable({ oaks, all, answer, isOld }: { oaks: Oak[]; all: Oak[]; answer: CoverageAnswer; isOld: boolean }) {
  const own = oaks.flatMap((oak, i) => {
    const pose = answer.poses[i];
    return pose ? [{ key: oak.key, oak, pose }] : [];
  });
  // A point counts for all OAKs together if one of them measures it.
  const columns = own.length > 1 ? [...own, { key: "together", oak: null, pose: answer.together }] : own;
  const { outcomes } = useStore(useApp().studio.catalog);
  const most = (name: string) => Math.max(...columns.map(({ pose }) => pose.lost[name] ?? 0));
  const names = [...new Set(columns.flatMap(({ pose }) => Object.keys(pose.lost)))].sort((a, b) => most(b) - most(a));
  const lost = names.map((name) => ({ name, outcome: outcomes.find((outcome) => outcome.name === name) }));
  return (
    <div class="scroll-x">
      <table class={`numbers ${columns.length > 2 ? "narrow" : ""} ${isOld ? "provisional" : ""}`}>
        <thead>
          <tr>
            <td />
            {columns.map(({ key, oak }) => (oak ? (
              <th key={key} scope="col" data-tip={oak.state.model}>
                <ColumnName index={all.indexOf(oak)} model={oak.state.model} isNarrow={columns.length > 2} />
              </th>
            ) : <th key={key} scope="col" data-tip="A point counts if one of the OAKs measures it">All</th>))}
          </tr>
        </thead>
        <tbody>
          <tr><th scope="row">Visible, %</th>{columns.map(({ key, pose }) => <td key={key}>{bareShare(pose.seen)}</td>)}</tr>
          <tr><th scope="row"><span class="swatch" style={{ background: css(outcomeColor(0)) }} />Measured, %</th>{columns.map(({ key, pose }) => <td key={key}><b>{bareShare(pose.measured)}</b></td>)}</tr>
          <tr><th scope="row" data-tip="The share of what the camera sees that it measures">Measured of visible, %</th>{columns.map(({ key, pose }) => <td key={key}>{pose.seen > 0 ? bareShare(pose.measured / pose.seen) : NONE}</td>)}</tr>
          <tr><th scope="row">Median |error|, mm</th>{columns.map(({ key, pose }) => <td key={key}>{bareMillimetres(pose.medianAbsoluteErrorM)}</td>)}</tr>
          {own.some(({ pose }) => pose.ownRobot !== null) && (
            <tr data-testid="own-robot"><th scope="row" data-tip="The share of the pixels that show the robot itself">Own robot, % of pixels</th>{columns.map(({ key, pose }) => <td key={key}>{pose.ownRobot === null ? NONE : bareShare(pose.ownRobot)}</td>)}</tr>
          )}
          {lost.map(({ name, outcome }) => (
            <tr key={name}>
              <th scope="row" data-tip={outcome?.documentation}>
                {outcome && <span class="swatch" style={{ background: css(outcomeColor(outcome.code)) }} />}{words(name)}, %
              </th>
              {columns.map(({ key, pose }) => <td key={key}>{bareShare(pose.lost[name] ?? 0)}</td>)}
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}
