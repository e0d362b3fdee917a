import { css, oakColor } from "../gpu/colormaps";
import type { Statistics } from "../protocol";
import { signedMillimetres } from "../util/format";
import { useStore } from "../util/store";
import { Section } from "./controls";
import { useApp } from "./context";

const WIDTH = 260;
const HEIGHT = 90;

/** The outline of a histogram as a path; the highest bar of all has the full height. */
function outline({ counts, fromM, toM }: Statistics["histogram"], from: number, to: number, highest: number): string {
  const x = (metres: number) => ((metres - from) / (to - from)) * WIDTH;
  const bin = (toM - fromM) / counts.length;
  const points = counts.flatMap((count, i) => {
    const y = (HEIGHT - (count / highest) * (HEIGHT - 4)).toFixed(1);
    return [`${x(fromM + i * bin).toFixed(1)},${y}`, `${x(fromM + (i + 1) * bin).toFixed(1)},${y}`];
  });
  return `M${x(fromM).toFixed(1)},${HEIGHT}L${points.join("L")}L${x(toM).toFixed(1)},${HEIGHT}`;
}

/** The errors of all OAKs. */
export function Histogram() {
  const { studio } = useApp();
  const frames = useStore(studio.frames);
  const { oaks } = useStore(studio.document);
  const shown = oaks.flatMap((oak, index) => {
    const histogram = frames.get(oak.key)?.header.statistics.histogram;
    const total = histogram?.counts.reduce((sum, count) => sum + count, 0) ?? 0;
    return histogram && total ? [{ oak, index, histogram }] : [];
  });
  const from = Math.min(...shown.map(({ histogram }) => histogram.fromM));
  const to = Math.max(...shown.map(({ histogram }) => histogram.toM));
  const highest = Math.max(...shown.flatMap(({ histogram }) => histogram.counts));
  const zero = ((0 - from) / (to - from)) * WIDTH;
  return (
    <Section title="Errors, measured minus true" testId="histogram">
      {shown.length === 0 ? <p class="hint">No pixel has a value.</p> : (
        <figure class={`chart ${shown.some(({ oak }) => frames.get(oak.key)?.isPreview) ? "provisional" : ""}`}>
          <svg viewBox={`0 0 ${WIDTH} ${HEIGHT}`} preserveAspectRatio="none" role="img" aria-label="Histogram of the errors">
            {zero > 0 && zero < WIDTH && <line class="zero" x1={zero} x2={zero} y1={0} y2={HEIGHT} />}
            {shown.map(({ oak, index, histogram }) => (
              <path
                key={oak.key}
                d={outline(histogram, from, to, highest)}
                fill={css(oakColor(index))}
                fill-opacity={shown.length > 1 ? 0.18 : 0.4}
                stroke={css(oakColor(index))}
                vector-effect="non-scaling-stroke"
              />
            ))}
          </svg>
          <figcaption><span>{signedMillimetres(from)}</span><span>{signedMillimetres(to)}</span></figcaption>
        </figure>
      )}
    </Section>
  );
}
