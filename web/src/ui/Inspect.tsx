import { css, oakColor, reasonColor } from "../gpu/colormaps";
import { WHOLE_IMAGE } from "../state/document";
import { bareMillimetres, bareShare, length, minus, NONE, share, signedMillimetres, words } from "../util/format";
import { useStore } from "../util/store";
import { Accuracy } from "./Accuracy";
import { Button, NumberField, Section } from "./controls";
import { useApp } from "./context";
import { ColumnName } from "./ColumnName";
import { Histogram } from "./Histogram";

/** What is known about the pixel under the mouse and about the images. */
export function Inspect() {
  return (
    <>
      <Readout />
      <Numbers />
      <Reasons />
      <Histogram />
      <Accuracy />
      <Findings />
    </>
  );
}

function Readout() {
  const { studio } = useApp();
  const probe = useStore(studio.probe);
  const { reasons } = useStore(studio.catalog);
  const { oaks } = useStore(studio.document);
  const index = oaks.findIndex(({ key }) => key === probe?.oak);
  const reason = probe ? reasons.find(({ code }) => code === probe.reason) : undefined;
  const isMeasured = probe?.reason === 0;
  return (
    <Section title="Pixel" testId="readout">
      {!probe && <p class="hint">Move the mouse over an image.</p>}
      {probe && (
        <>
          <div class={`verdict ${isMeasured ? "" : "missing"}`}>
            <span class="swatch" style={{ background: css(isMeasured ? oakColor(Math.max(index, 0)) : reasonColor(probe.reason)) }} />
            <div>
              <strong>{isMeasured ? `${length(probe.measuredM)}, ${signedMillimetres(probe.errorM)}` : words(reason?.name ?? "unknown")}</strong>
              <p>{isMeasured ? oaks[index]?.state.model : reason?.documentation}</p>
            </div>
          </div>
          <dl class="facts">
            <dt>Pixel</dt><dd>{probe.pixel[0]}, {probe.pixel[1]}</dd>
            <dt>True depth</dt><dd>{length(probe.trueM)}</dd>
            <dt>Measured depth</dt><dd>{length(probe.measuredM)}</dd>
            <dt>Error</dt><dd>{signedMillimetres(probe.errorM)}{relative(probe.errorM, probe.trueM)}</dd>
            <dt>Disparity</dt><dd>{probe.disparityPx === null ? NONE : `${probe.disparityPx.toFixed(2)} px`}</dd>
            <dt data-tip="The distance to the next depth that the sensor can report">Depth step</dt><dd>{length(probe.stepM === null ? null : Math.abs(probe.stepM))}</dd>
            <dt>Object</dt><dd class="path">{probe.object ?? NONE}</dd>
            {probe.occluder && <><dt>Occluded by</dt><dd class="path">{probe.occluder}</dd></>}
          </dl>
        </>
      )}
    </Section>
  );
}

function relative(errorM: number | null, trueM: number | null): string {
  if (errorM === null || !trueM) return "";
  return ` (${minus(((100 * errorM) / trueM).toFixed(2))} %)`;
}

const EDGES = ["Left", "Top", "Right", "Bottom"];

/** The statistics of all OAKs, one column each. */
function Numbers() {
  const { studio } = useApp();
  const frames = useStore(studio.frames);
  const { oaks, region } = useStore(studio.document);
  const shown = oaks.filter(({ key }) => frames.has(key));
  const isWhole = region.every((edge, i) => edge === WHOLE_IMAGE[i]);
  const row = (name: string, tip: string, value: (key: string) => string) => (
    <tr>
      <th scope="row" data-tip={tip}>{name}</th>
      {shown.map(({ key }) => <td key={key} class={frames.get(key)?.isPreview ? "provisional" : ""}>{value(key)}</td>)}
    </tr>
  );
  const statistics = (key: string) => frames.get(key)?.header.statistics;
  const setEdge = (index: number, value: number) => studio.document.commit("region", (document) => {
    const region = document.region.map((edge, i) => (i === index ? value / 100 : edge)) as typeof document.region;
    return region[0] < region[2] && region[1] < region[3] ? { ...document, region } : document;
  });
  return (
    <Section
      title={isWhole ? "Whole image" : "Rectangle"}
      testId="statistics"
      actions={!isWhole && (
        <Button label="Whole image" class="text" onClick={() => studio.document.commit("region", (document) => ({ ...document, region: WHOLE_IMAGE }))} />
      )}
    >
      <div class="scroll-x">
        <table class={`numbers ${shown.length > 2 ? "narrow" : ""}`}>
          <thead>
            <tr>
              <td />
              {shown.map(({ key, state }) => (
                <th key={key} scope="col" data-tip={state.model}>
                  <ColumnName index={oaks.findIndex((oak) => oak.key === key)} model={state.model} isNarrow={shown.length > 2} />
                </th>
              ))}
            </tr>
          </thead>
          <tbody>
            {row("Fill rate, %", "The share of the pixels that show a surface and have a value", (key) => bareShare(statistics(key)?.fillRate))}
            {row("Median error, mm", "Measured minus true", (key) => bareMillimetres(statistics(key)?.medianErrorM, true))}
            {row("Median |error|, mm", "The median of the size of the error", (key) => bareMillimetres(statistics(key)?.medianAbsoluteErrorM))}
            {row("Median |error|, %", "The median of the size of the error, relative to the true depth", (key) => statistics(key)?.medianAbsoluteErrorPercent?.toFixed(2) ?? NONE)}
            {row("95th percentile, mm", "95 % of the errors are smaller than this", (key) => bareMillimetres(statistics(key)?.p95AbsoluteErrorM))}
            {row("Pixels, thousands", "Those that show a surface", (key) => ((statistics(key)?.pixels ?? 0) / 1000).toFixed(0))}
          </tbody>
        </table>
      </div>
      {isWhole ? <p class="hint">Drag a rectangle on an image to measure a part of it.</p> : (
        <div class="quad">
          {EDGES.map((label, i) => (
            <NumberField key={label} label={label} value={(region[i] ?? 0) * 100} onChange={(value) => setEdge(i, value)} step={1} digits={1} minimum={0} maximum={100} unit="%" />
          ))}
        </div>
      )}
      {isWhole && <Button label="Rectangle…" class="text" onClick={() => studio.document.commit("region", (document) => ({ ...document, region: [0.25, 0.25, 0.75, 0.75] }))} />}
    </Section>
  );
}

/** The shares of the reasons why pixels have no value. */
function Reasons() {
  const { studio } = useApp();
  const { reasons } = useStore(studio.catalog);
  const frames = useStore(studio.frames);
  const { oaks } = useStore(studio.document);
  const rows = oaks.flatMap((oak) => {
    const frame = frames.get(oak.key);
    const counts = frame?.header.statistics.reasons;
    const total = counts?.reduce((sum, count) => sum + count, 0) ?? 0;
    return counts && total ? [{ oak, shares: counts.map((count) => count / total), grey: frame?.isPreview ? "provisional" : "" }] : [];
  });
  const missing = reasons.filter(({ code }) => code !== 0 && rows.some(({ shares }) => (shares[code] ?? 0) > 0));
  return (
    <Section title="Why pixels have no value" testId="reasons">
      {missing.length === 0 && <p class="hint">{rows.length ? "Every pixel has a value." : NONE}</p>}
      {rows.map(({ oak, shares, grey }) => (
        <div key={oak.key} class={`stack ${grey}`} role="img" aria-label={`${oak.state.model}: ${missing.map(({ code, name }) => `${words(name)} ${share(shares[code])}`).join(", ")}`}>
          {reasons.map(({ code }) => (shares[code] ? <span key={code} style={{ width: `${(shares[code] ?? 0) * 100}%`, background: css(reasonColor(code)) }} /> : null))}
        </div>
      ))}
      <div class="scroll-x">
        <table class={`numbers ${rows.length > 2 ? "narrow" : ""}`}>
          <tbody>
            {missing.map(({ code, name, documentation }) => (
              <tr key={code}>
                <th scope="row" data-tip={documentation}><span class="swatch" style={{ background: css(reasonColor(code)) }} />{words(name)}, %</th>
                {rows.map(({ oak, shares, grey }) => <td key={oak.key} class={grey}>{bareShare(shares[code] ?? 0)}</td>)}
              </tr>
            ))}
          </tbody>
        </table>
      </div>
    </Section>
  );
}

/** What the server remarks about the frames. */
function Findings() {
  const { studio } = useApp();
  const frames = useStore(studio.frames);
  const { oaks } = useStore(studio.document);
  const all = oaks.flatMap(({ key, state }) => (frames.get(key)?.header.findings ?? []).map((finding) => ({ key, state, finding })));
  if (all.length === 0) return null;
  return (
    <Section title={`Remarks (${all.length})`} isOpen={false}>
      <ul class="findings">
        {all.map(({ key, state, finding }, i) => (
          <li key={`${key}${i}`} class={finding.level}>
            <strong>{state.model}, {finding.place}</strong>: {finding.message}{finding.remedy && `; ${finding.remedy}`}
          </li>
        ))}
      </ul>
    </Section>
  );
}
