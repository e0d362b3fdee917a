import { useLayoutEffect, useRef } from "preact/hooks";
import { css, DEPTH_MAPS, depthTable, errorTable, oakColor, reasonColor, TABLE_SIZE } from "../gpu/colormaps";
import type { Scales } from "../gpu/scales";
import type { Comparison, PanelKind } from "../state/display";
import { words } from "../util/format";
import { useStore } from "../util/store";
import { Button, NumberField, Select } from "./controls";
import { useApp } from "./context";

/** The colour scales of the images, which can be changed here. */
export function Legend({ kinds, scales }: { kinds: PanelKind[]; scales: Scales }) {
  const { studio } = useApp();
  const { comparison } = useStore(studio.display);
  if (comparison?.mode === "difference") return <div class="legend"><DifferenceScale comparison={comparison} scales={scales} /></div>;
  const hasDepth = kinds.includes("depth") || kinds.includes("sensor") || kinds.includes("confidence");
  return (
    <div class="legend">
      {hasDepth && <DepthScale scales={scales} />}
      {kinds.includes("error") && <ErrorScale scales={scales} />}
      <div class="swatches">
        {kinds.includes("reason") && <ReasonLegend />}
        {(hasDepth || kinds.includes("error")) && <NoValue />}
      </div>
    </div>
  );
}

function NoValue() {
  return <span class="swatch-label"><span class="swatch hatch" />No value</span>;
}

function DepthScale({ scales }: { scales: Scales }) {
  const { studio } = useApp();
  const { depthMap, depthRange } = useStore(studio.display);
  const [near, far] = scales.depth;
  return (
    <div class="scale" role="group" aria-label="Depth scale">
      <span class="scale-name">Depth</span>
      <NumberField label="Nearest depth" isLabelled={false} value={near} minimum={0} maximum={far - 0.001} step={0.1} digits={3} onChange={(value) => studio.show({ depthRange: [value, far] })} />
      <Gradient bytes={depthTable(depthMap)} />
      <NumberField label="Farthest depth" isLabelled={false} value={far} minimum={near + 0.001} maximum={65.535} step={0.1} digits={3} unit="m" onChange={(value) => studio.show({ depthRange: [near, value] })} />
      <Button label="Auto" class="chip" tip="Follow the images" isOn={depthRange === null} onClick={() => studio.show({ depthRange: depthRange ? null : scales.depth })} />
      <Select
        label="Colour map"
        isLabelled={false}
        value={depthMap}
        options={DEPTH_MAPS.map(({ map, title }) => ({ value: map, title }))}
        onChange={(depthMap) => studio.show({ depthMap })}
        testId="depth-map"
      />
    </div>
  );
}

function ErrorScale({ scales }: { scales: Scales }) {
  return (
    <div class="scale" role="group" aria-label="Error scale">
      <span class="scale-name">Error</span>
      <span class="end">too near</span>
      <Gradient bytes={errorTable()} />
      <span class="end">too far</span>
      <ErrorEnd scales={scales} />
    </div>
  );
}

/** The colours of the difference of two OAKs. */
function DifferenceScale({ comparison, scales }: { comparison: Comparison; scales: Scales }) {
  const { studio } = useApp();
  const { oaks } = useStore(studio.document);
  const sides = [comparison.left, comparison.right].map(({ oak }) => {
    const index = oaks.findIndex(({ key }) => key === oak);
    return { name: oaks[index]?.state.model ?? "", color: css(oakColor(Math.max(index, 0))) };
  });
  const [first, second] = [sides[0]?.name, sides[1]?.name];
  const isSame = first === second;
  return (
    <>
      <div class="scale" role="group" aria-label="Scale of the difference">
        <span class="end">{isSame ? "second is better" : `${second} is better`}</span>
        <Gradient bytes={errorTable()} />
        <span class="end">{isSame ? "first is better" : `${first} is better`}</span>
        <ErrorEnd scales={scales} />
      </div>
      {sides.map(({ name, color }, i) => (
        <span key={i} class="swatch-label"><span class="swatch" style={{ background: color }} />{`Only ${isSame ? ["the first", "the second"][i] : name}`}</span>
      ))}
      <NoValue />
    </>
  );
}

/** The end of the error scale with its unit. */
function ErrorEnd({ scales }: { scales: Scales }) {
  const { studio } = useApp();
  const { errorUnit, errorRange } = useStore(studio.display);
  const factor = errorUnit === "mm" ? 1000 : 1;
  const setUnit = () => studio.show({ errorUnit: errorUnit === "mm" ? "%" : "mm", errorRange: null });
  return (
    <>
      <span class="end">±</span>
      <NumberField
        label="End of the error scale"
        isLabelled={false}
        value={scales.error * factor}
        minimum={0.01}
        maximum={65535}
        step={errorUnit === "mm" ? 5 : 0.5}
        digits={2}
        onChange={(value) => studio.show({ errorRange: value / factor })}
      />
      <Button label={errorUnit} class="chip" tip="Switch between millimetres and percent" onClick={setUnit} testId="error-unit" />
      <Button label="Auto" class="chip" tip="Follow the images" isOn={errorRange === null} onClick={() => studio.show({ errorRange: errorRange ? null : scales.error })} />
    </>
  );
}

function ReasonLegend() {
  const { studio } = useApp();
  const { reasons } = useStore(studio.catalog);
  const frames = useStore(studio.frames);
  const present = (code: number) => [...frames.values()].some(({ header }) => (header.statistics.reasons[code] ?? 0) > 0);
  return (
    <>
      {reasons.filter(({ code }) => code === 0 || present(code)).map(({ code, name, documentation }) => (
        <span key={code} class="swatch-label" data-tip={documentation}>
          <span class="swatch" style={{ background: css(reasonColor(code)) }} />
          {words(name)}
        </span>
      ))}
    </>
  );
}

function Gradient({ bytes }: { bytes: Uint8Array<ArrayBuffer> }) {
  const canvas = useRef<HTMLCanvasElement>(null);
  useLayoutEffect(() => {
    const pixels = new ImageData(new Uint8ClampedArray(bytes), TABLE_SIZE, 1);
    canvas.current?.getContext("2d")?.putImageData(pixels, 0, 0);
  }, [bytes]);
  return <canvas ref={canvas} class="gradient" width={TABLE_SIZE} height={1} />;
}
