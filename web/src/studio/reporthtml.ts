import { bareMillimetres, bareShare, decimal, words } from "../util/format";
import type { Report, Row } from "./report";

/** A picture of a row, as the data of an address. */
export interface Picture {
  title: string;
  address: string;
}

const STYLE = `
body { font: 15px/1.5 system-ui, sans-serif; max-width: 70rem; margin: 2rem auto; padding: 0 1rem; color: #191e25; }
table { border-collapse: collapse; width: 100%; } th, td { padding: .35rem .6rem; border-bottom: 1px solid #d3d9e1; text-align: right; vertical-align: top; }
th:first-child, td:first-child, td.text, th.text { text-align: left; } .best { font-weight: 700; } .row { break-inside: avoid; }
.pictures { display: grid; grid-template-columns: repeat(3, 1fr); gap: .6rem; } .pictures img { width: 100%; } p.note { color: #525c6b; }
@page { size: A4 landscape; margin: 12mm; }`;

function escaped(text: string): string {
  return text.replaceAll("&", "&amp;").replaceAll("<", "&lt;").replaceAll(">", "&gt;").replaceAll('"', "&quot;");
}

function regionText({ region }: Report): string {
  if ("object" in region) return region.object;
  const corner = (point: readonly number[]) => point.map((value) => decimal(value, 3)).join(", ");
  return `the box from (${corner(region.minimum)}) to (${corner(region.maximum)}) m`;
}

/** The largest losses of a row. */
function losses({ coverage }: Row): string {
  const sorted = Object.entries(coverage.lost).sort(([, a], [, b]) => b - a).slice(0, 3);
  return sorted.map(([name, share]) => `${words(name).toLowerCase()} ${bareShare(share)} %`).join(", ");
}

/** Writes a report as one page that needs no other file. `pictures` are those of each row. */
export function reportHtml(report: Report, pictures: Picture[][], version: string): string {
  const { rows, toleranceMm } = report;
  const best = (light: string) => Math.max(...rows.filter((row) => row.light === light).map(({ coverage }) => coverage.measured));
  const line = (row: Row) => {
    const { state, light, coverage } = row;
    const [x, y, z] = state.pose.position.map((metres) => decimal(metres, 3));
    const cells = [
      bareShare(coverage.seen), bareShare(coverage.measured), coverage.seen > 0 ? bareShare(coverage.measured / coverage.seen) : "–", bareMillimetres(coverage.medianAbsoluteErrorM),
    ];
    return `<tr${coverage.measured === best(light) ? ' class="best"' : ""}><td>${escaped(state.model)}</td><td class="text">${light}</td><td class="text">${escaped(words(state.engine))}</td>`
      + `<td class="text">${x}, ${y}, ${z}</td>${cells.map((cell) => `<td>${cell}</td>`).join("")}<td class="text">${escaped(losses(row))}</td></tr>`;
  };
  const section = ({ state, light }: Row, i: number) => `<div class="row"><h2>${escaped(state.model)}, ${light}</h2><div class="pictures">`
    + (pictures[i] ?? []).map(({ title, address }) => `<img alt="${escaped(title)}" src="${address}">`).join("") + "</div></div>";
  const tolerance = toleranceMm === null ? "with any error" : `with an error of at most ${decimal(toleranceMm, 3)} mm`;
  return `<!doctype html>
<html lang="en"><head><meta charset="utf-8"><title>Coverage of ${escaped(regionText(report))}</title><style>${STYLE}</style></head><body>
<h1>Coverage of ${escaped(regionText(report))}</h1>
<p>Scene: ${escaped(report.scene)}. A point of the surface counts as measured ${tolerance}. The best OAK in each light is bold.</p>
<table><thead><tr><th>Model</th><th class="text">Light</th><th class="text">Engine</th><th class="text">Position, m</th><th>Visible, %</th><th>Measured, %</th><th>Measured of visible, %</th><th>Median |error|, mm</th><th class="text">Lost most</th></tr></thead>
<tbody>${rows.map(line).join("\n")}</tbody></table>
${rows.map(section).join("\n")}
<p class="note">Simulated by oaktwin ${escaped(version)}. Stereo pairs are rendered and matched; by night, the only light is that of the dot projector.</p>
</body></html>
`;
}
