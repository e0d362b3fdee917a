import { useEffect, useLayoutEffect, useRef, useState } from "preact/hooks";
import uPlot from "uplot";
import { css, oakColor } from "../gpu/colormaps";
import type { AccuracyCurve } from "../protocol";
import type { Oak } from "../state/document";
import { AccuracyCurves, type Measured } from "../studio/accuracy";
import { decimal } from "../util/format";
import { useDarkSystem } from "../util/scheme";
import { useStore } from "../util/store";
import { Section } from "./controls";
import { useApp } from "./context";

/** The height of the chart and its texts, in units of the page's font. */
const HEIGHT = 13;
const TEXT = 0.85;

/** The error over distance of all OAKs, with the maker's bands and the distance under the mouse. */
export function Accuracy() {
  return (
    <Section title="Accuracy over distance" testId="accuracy">
      <Chart />
    </Section>
  );
}

function Chart() {
  const { studio } = useApp();
  const curves = useRef<AccuracyCurves | null>(null);
  curves.current ??= new AccuracyCurves(studio);
  const own = curves.current;
  useEffect(() => {
    own.want(true);
    return () => own.want(false);
  }, [own]);
  const measured = useStore(own);
  const { oaks, selected } = useStore(studio.document);
  const display = useStore(studio.display);
  const holder = useRef<HTMLDivElement>(null);
  const plot = useRef<uPlot | null>(null);
  const marked = useRef<number | null>(null);
  const isDarkSystem = useDarkSystem();
  const [width, setWidth] = useState(0);
  useLayoutEffect(() => {
    const element = holder.current;
    if (!element) return;
    const observer = new ResizeObserver(() => setWidth(element.clientWidth));
    observer.observe(element);
    return () => observer.disconnect();
  }, []);
  useEffect(() => {
    if (!holder.current || width === 0) return;
    plot.current?.destroy();
    plot.current = draw(holder.current, oaks, measured, measured.get(selected)?.curve?.bands ?? [], marked);
    return () => {
      plot.current?.destroy();
      plot.current = null;
    };
  }, [measured, selected, oaks.map(({ key, state }) => key + state.model).join(), display.theme, isDarkSystem, width]);
  useEffect(() => studio.probe.subscribe(() => {
    marked.current = studio.probe.get()?.trueM ?? null;
    plot.current?.redraw(false);
  }), [studio]);
  const error = [...measured.values()].find(({ error }) => error !== null)?.error;
  const isEmpty = [...measured.values()].every(({ curve }) => curve === null);
  return (
    <>
      <div ref={holder} class="plot" />
      {error && <p class="problem" role="alert">{error}</p>}
      {isEmpty && !error && <p class="hint">Measuring…</p>}
      {!isEmpty && <p class="hint">Median error at a flat target. Shaded: what the maker specifies.</p>}
    </>
  );
}

/** Merges curves with different distances into the columns that uPlot wants. */
function merge(curves: AccuracyCurve[]): uPlot.AlignedData {
  const distances = [...new Set(curves.flatMap(({ distancesM }) => distancesM))].sort((a, b) => a - b);
  const columns = curves.map((curve) => {
    const at = new Map(curve.distancesM.map((distance, i) => [distance, curve.errorPercent[i] ?? null]));
    return distances.map((distance) => (at.has(distance) ? (at.get(distance) as number | null) : undefined));
  });
  return [distances, ...columns] as uPlot.AlignedData;
}

function draw(
  holder: HTMLElement, oaks: Oak[], measured: ReadonlyMap<string, Measured>, bands: AccuracyCurve["bands"], marked: { current: number | null },
): uPlot | null {
  const shown = oaks.flatMap((oak, index) => {
    const curve = measured.get(oak.key)?.curve;
    return curve ? [{ oak, index, curve }] : [];
  });
  if (shown.length === 0) return null;
  const style = getComputedStyle(document.documentElement);
  const unit = Number.parseFloat(style.fontSize);
  const color = (name: string) => style.getPropertyValue(name).trim();
  // The chart scales whole pixels only with the density of the screen.
  const axis = { stroke: color("--muted"), grid: { stroke: color("--line"), width: 1 }, ticks: { stroke: color("--line"), width: 1 }, font: `${Math.round(TEXT * unit)}px system-ui`, size: 2.6 * unit };
  const errors = shown.flatMap(({ curve }) => curve.errorPercent.filter((error) => error !== null));
  const top = Math.max(1, ...errors.map(Math.abs), ...bands.map(({ percent }) => percent)) * 1.1;
  const bottom = Math.min(0, ...errors) * 1.1;
  const options: uPlot.Options = {
    width: Math.max(holder.clientWidth, 120),
    height: HEIGHT * unit,
    legend: { show: false },
    cursor: { drag: { x: false, y: false }, points: { size: 5 } },
    scales: { x: { time: false }, y: { range: [bottom, top] } },
    axes: [
      { ...axis, values: (_, splits) => splits.map((metres) => `${metres} m`) },
      { ...axis, size: 3.2 * unit, values: (_, splits) => splits.map((percent) => `${decimal(percent, 2)} %`) },
    ],
    series: [{}, ...shown.map(({ oak, index }) => ({ label: oak.state.model, stroke: css(oakColor(index)), width: 2, points: { show: false } }))],
    hooks: {
      drawClear: [(plot) => drawBands(plot, bands, color("--band"))],
      draw: [(plot) => drawMarker(plot, marked.current)],
    },
  };
  return new uPlot(options, merge(shown.map(({ curve }) => curve)), holder);
}

/** Shades the errors that the maker allows. */
function drawBands(plot: uPlot, bands: AccuracyCurve["bands"], color: string): void {
  const { ctx } = plot;
  ctx.save();
  ctx.beginPath();
  ctx.rect(plot.bbox.left, plot.bbox.top, plot.bbox.width, plot.bbox.height);
  ctx.clip();
  ctx.fillStyle = color;
  for (const { fromM, toM, percent } of bands) {
    const [left, right] = [plot.valToPos(fromM, "x", true), plot.valToPos(toM, "x", true)];
    const [top, bottom] = [plot.valToPos(percent, "y", true), plot.valToPos(-percent, "y", true)];
    ctx.fillRect(left, top, right - left, bottom - top);
  }
  ctx.restore();
}

function drawMarker(plot: uPlot, metres: number | null): void {
  const { ctx, bbox } = plot;
  const [from = 0, to = 0] = [plot.scales.x?.min ?? 0, plot.scales.x?.max ?? 0];
  if (metres === null || metres < from || metres > to) return;
  const x = plot.valToPos(metres, "x", true);
  ctx.save();
  ctx.strokeStyle = "#ff2d78";
  ctx.lineWidth = devicePixelRatio;
  ctx.beginPath();
  ctx.moveTo(x, bbox.top);
  ctx.lineTo(x, bbox.top + bbox.height);
  ctx.stroke();
  ctx.restore();
}
