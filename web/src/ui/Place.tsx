import { useEffect, useRef, useState } from "preact/hooks";
import { css, reasonColor } from "../gpu/colormaps";
import { api } from "../net/api";
import type { CoverageAnswer, OakState, Vec3 } from "../protocol";
import type { Oak, Target } from "../state/document";
import { targetBounds } from "../studio/view";
import { bareMillimetres, bareShare, words } from "../util/format";
import { useStore } from "../util/store";
import { Button, NumberField, Section } from "./controls";
import { useApp } from "./context";
import { ColumnName } from "./ColumnName";
import { Sweep } from "./Sweep";

/** Which share of a region the OAKs measure, and which poses measure more. */
export function Place() {
  const { studio } = useApp();
  const { target } = useStore(studio.document);
  return (
    <>
      <Region target={target} />
      {target && <Coverage target={target} />}
      {target && <Sweep target={target} />}
    </>
  );
}

function Region({ target }: { target: Target | null }) {
  const { studio, view } = useApp();
  const scene = useStore(studio.scene);
  const set = (target: Target | null) => studio.document.commit("target", (document) => ({ ...document, target }));
  const bounds = targetBounds(target, scene);
  const toBox = () => {
    const [minimum, maximum] = bounds ?? scene?.bounds ?? [[-1, -1, 0], [1, 1, 1]];
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
          {scene?.objects.map(({ path }) => <option key={path} value={path} selected={target !== null && "object" in target && target.object === path}>{path}</option>)}
        </select>
      </label>
      <div class="row">
        <Button label="Click an object" tip="The next click in the 3D view chooses the object" onClick={() => view.get()?.isPicking.set(true)} />
        <Button label="Box" tip="A box in the world, at first around the chosen object" isOn={target !== null && "minimum" in target} onClick={toBox} />
        {target && <Button label="None" class="text" onClick={() => set(null)} />}
      </div>
      {target && "minimum" in target && <BoxFields box={target} onChange={set} />}
    </Section>
  );
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

/** Computes the coverage of states; computes again when they change. */
export function useCoverage(scene: string, states: OakState[], target: Target): { answer: CoverageAnswer | null; error: string | null } {
  const { studio } = useApp();
  const [result, setResult] = useState<{ answer: CoverageAnswer | null; error: string | null }>({ answer: null, error: null });
  const key = JSON.stringify([scene, states, target]);
  const latest = useRef(key);
  latest.current = key;
  useEffect(() => {
    const running = new AbortController();
    const timer = setTimeout(() => {
      api.coverage({ scene, states, region: target }, running.signal).then(
        (answer) => latest.current === key && setResult({ answer, error: null }),
        (error: unknown) => {
          if (!running.signal.aborted) setResult({ answer: null, error: error instanceof Error ? error.message : String(error) });
        },
      );
    }, DELAY);
    return () => {
      clearTimeout(timer);
      running.abort();
    };
  }, [key, studio]);
  return result;
}

/** What each OAK measures of the region now. */
function Coverage({ target }: { target: Target }) {
  const { studio } = useApp();
  const { oaks, scene } = useStore(studio.document);
  const shown = oaks.filter((oak) => !oak.isHidden && studio.hasDepth(oak.state));
  const { answer, error } = useCoverage(scene, shown.map(({ state }) => state), target);
  return (
    <Section title="Coverage" testId="coverage">
      {error && <p class="problem" role="alert">{error}</p>}
      {!answer && !error && <p class="hint">Computing…</p>}
      {answer && <CoverageTable oaks={shown} all={oaks} answer={answer} />}
      <p class="hint">To paint what is lost onto the surfaces, show the true points coloured by reason in the 3D view.</p>
      <Button
        label="Paint the reasons"
        onClick={() => studio.show({ cloud: "truth", cloudColor: "reason" })}
      />
    </Section>
  );
}

function CoverageTable({ oaks, all, answer }: { oaks: Oak[]; all: Oak[]; answer: CoverageAnswer }) {
  const columns = oaks.flatMap((oak, i) => {
    const pose = answer.poses[i];
    return pose ? [{ oak, pose }] : [];
  });
  const { reasons } = useStore(useApp().studio.catalog);
  const most = (name: string) => Math.max(...columns.map(({ pose }) => pose.lost[name] ?? 0));
  const names = [...new Set(columns.flatMap(({ pose }) => Object.keys(pose.lost)))].sort((a, b) => most(b) - most(a));
  // Those of visibility, such as "hidden", are no reasons of pixels.
  const lost = names.map((name) => ({ name, reason: reasons.find((reason) => reason.name === name) }));
  return (
    <div class="scroll-x">
      <table class="numbers">
        <thead>
          <tr>
            <td />
            {columns.map(({ oak }) => (
              <th key={oak.key} scope="col" data-tip={oak.state.model}>
                <ColumnName index={all.indexOf(oak)} model={oak.state.model} isShort={columns.length > 2} />
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          <tr><th scope="row">Visible, %</th>{columns.map(({ oak, pose }) => <td key={oak.key}>{bareShare(pose.seen)}</td>)}</tr>
          <tr><th scope="row">Measured, %</th>{columns.map(({ oak, pose }) => <td key={oak.key}><b>{bareShare(pose.measured)}</b></td>)}</tr>
          <tr><th scope="row">Median |error|, mm</th>{columns.map(({ oak, pose }) => <td key={oak.key}>{bareMillimetres(pose.medianAbsoluteErrorM)}</td>)}</tr>
          {lost.map(({ name, reason }) => (
            <tr key={name}>
              <th scope="row" data-tip={reason?.documentation}>
                {reason && <span class="swatch" style={{ background: css(reasonColor(reason.code)) }} />}{words(name)}, %
              </th>
              {columns.map(({ oak, pose }) => <td key={oak.key}>{bareShare(pose.lost[name] ?? 0)}</td>)}
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}
