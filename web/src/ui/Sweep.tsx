import { useEffect, useRef, useState } from "preact/hooks";
import { api } from "../net/api";
import type { PoseCoverage } from "../protocol";
import { changeOak, selectedOak, type Target, sceneAt } from "../state/document";
import { height, MAX_POSES, rank, type Ranked, type Span, sweep } from "../studio/sweep";
import { bareMillimetres, bareShare, decimal, NONE } from "../util/format";
import { toAngles } from "../util/pose";
import { useStore } from "../util/store";
import { Button, Check, NumberField, Section } from "./controls";
import { Heading } from "./ColumnName";
import { useApp } from "./context";

/** How many poses are computed by one request: the ranking grows with each answer. */
const AT_ONCE = 3;

/** How many of the ranked poses are listed. */
const LISTED = 12;

/** Tries heights and tilts, and ranks the poses by what they measure of the region. */
export function Sweep({ target, tolerance }: { target: Target; tolerance: number | null }) {
  const { studio } = useApp();
  const document = useStore(studio.document);
  const up = useStore(studio.scene)?.up ?? "z";
  const oak = selectedOak(document);
  const now = oak ? height(oak.state, up) : 1;
  const [heights, setHeights] = useState<Span>(() => ({ from: Number((now - 0.5).toFixed(2)), to: Number((now + 0.5).toFixed(2)), count: 5 }));
  const [tilts, setTilts] = useState<Span>(() => {
    const pitch = oak ? Math.round(toAngles(oak.state.pose.quaternion, up).pitch) : 0;
    return { from: pitch - 20, to: pitch + 20, count: 3 };
  });
  const [isForAll, setForAll] = useState(false);
  const [ranked, setRanked] = useState<Ranked[] | null>(null);
  const [problem, setProblem] = useState<string | null>(null);
  const running = useRef<AbortController | null>(null);
  /** The number of poses that were tried; null while none are. */
  const [done, setDone] = useState<number | null>(null);
  useEffect(() => () => running.current?.abort(), []);
  // A ranking belongs to the region that it was made for.
  useEffect(() => {
    running.current?.abort();
    setRanked(null);
    setProblem(null);
  }, [sceneAt(document), JSON.stringify(target), tolerance]);
  if (!oak) return null;
  const shown = isForAll ? document.oaks.filter((oak) => !oak.isHidden && studio.hasDepth(oak.state)) : [oak];
  const count = heights.count * tilts.count * shown.length;
  const run = async () => {
    const tried = sweep(shown, heights, tilts, up);
    const own = new AbortController();
    running.current = own;
    setProblem(null);
    const poses: PoseCoverage[] = [];
    try {
      while (poses.length < tried.length) {
        setDone(poses.length);
        const states = tried.slice(poses.length, poses.length + AT_ONCE).map(({ state }) => state);
        poses.push(...(await api.coverage({ scene: sceneAt(document), states, region: target, toleranceMm: tolerance }, own.signal)).poses);
        setRanked(rank(tried, poses, up));
      }
    } catch (error) {
      if (!own.signal.aborted) setProblem(error instanceof Error ? error.message : String(error));
    } finally {
      setDone(null);
    }
  };
  const take = ({ key, state }: Ranked) => studio.document.commit("sweep", (document) =>
    changeOak({ ...document, selected: key }, key, (before) => ({ ...before, pose: state.pose })));
  return (
    <Section title="Sweep" testId="sweep">
      <SpanFields name="Height" unit="m" span={heights} onChange={setHeights} />
      <SpanFields name="Tilt" unit="°" span={tilts} onChange={setTilts} />
      {document.oaks.length > 1 && <Check label="All models, not only the selected OAK" isOn={isForAll} onChange={setForAll} />}
      <div class="row">
        {done !== null
          ? <Button label="Cancel" onClick={() => running.current?.abort()} />
          : <Button label={`Try ${count} poses`} class="primary" isDisabled={count > MAX_POSES} onClick={() => void run()} testId="run-sweep" />}
        {done !== null && <span class="hint" role="status">{`${done} of ${count}`}</span>}
        {count > MAX_POSES && <span class="problem">{`At most ${MAX_POSES} poses.`}</span>}
      </div>
      {problem && <p class="problem" role="alert">{problem}</p>}
      {ranked && <div class="scroll-x"><Ranking ranked={ranked.slice(0, LISTED)} onTake={take} /></div>}
    </Section>
  );
}

function SpanFields({ name, unit, span, onChange }: { name: string; unit: string; span: Span; onChange: (span: Span) => void }) {
  const [step, digits] = unit === "m" ? [0.1, 2] : [5, 1];
  return (
    <div class="triple">
      <NumberField label={name} value={span.from} unit={unit} step={step} digits={digits} onChange={(from) => onChange({ ...span, from })} />
      <NumberField label="to" value={span.to} unit={unit} step={step} digits={digits} onChange={(to) => onChange({ ...span, to })} />
      <NumberField label="steps" value={span.count} step={1} digits={0} minimum={1} maximum={20} onChange={(count) => onChange({ ...span, count: Math.round(count) })} />
    </div>
  );
}

function Ranking({ ranked, onTake }: { ranked: Ranked[]; onTake: (one: Ranked) => void }) {
  const hasModels = new Set(ranked.map(({ state }) => state.model)).size > 1;
  return (
    <table class="numbers ranking narrow">
      <thead>
        <tr>
          {hasModels && <th scope="col" class="model">OAK</th>}
          <Heading name="Height, m" />
          <Heading name="Tilt, °" />
          <Heading name="Measured, %" tip="The share of the surface that is measured" />
          <Heading name="Of visible, %" tip="The share of what the camera sees there that it measures" />
          <Heading name="|Error|, mm" tip="The median of the absolute errors" />
          <td />
        </tr>
      </thead>
      <tbody>
        {ranked.map((one, i) => (
          <tr key={i}>
            {hasModels && <td class="model">{one.state.model}</td>}
            <td>{decimal(one.heightM, 2)}</td>
            <td>{decimal(one.tiltDeg, 0)}</td>
            <td><b>{bareShare(one.coverage.measured)}</b></td>
            <td>{one.coverage.seen > 0 ? bareShare(one.coverage.measured / one.coverage.seen) : NONE}</td>
            <td>{bareMillimetres(one.coverage.medianAbsoluteErrorM)}</td>
            <td><Button label="Take" class="text" tip="Move this OAK there" onClick={() => onTake(one)} /></td>
          </tr>
        ))}
      </tbody>
    </table>
  );
}
