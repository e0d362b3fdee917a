import { useRef, useState } from "preact/hooks";
import { findScales } from "../gpu/scales";
import type { PanelKind } from "../state/display";
import type { Target } from "../state/document";
import { makeReport, type Report as Made, reportCsv, type Row } from "../studio/report";
import { type Picture, reportHtml } from "../studio/reporthtml";
import { save } from "../util/away";
import { useStore } from "../util/store";
import { captionedFrame } from "./caption";
import { type App, useApp } from "./context";
import { Button, Section } from "./controls";
import { titleOf } from "./Panel";

const KINDS: PanelKind[] = ["color", "sensor", "error"];

/** Measures all OAKs by day and by night, for a table with pictures. */
export function Report({ target, tolerance }: { target: Target; tolerance: number | null }) {
  const app = useApp();
  const { studio } = app;
  const { oaks } = useStore(studio.document);
  const [progress, setProgress] = useState<string | null>(null);
  const running = useRef<AbortController | null>(null);
  const make = async (format: "html" | "csv") => {
    const own = new AbortController();
    running.current = own;
    try {
      const report = await makeReport(studio, target, tolerance, own.signal, (done, of) => setProgress(`${done} of ${of}`));
      const file = format === "csv" ? new Blob([reportCsv(report)], { type: "text/csv" }) : await page(app, report);
      save(`oaktwin-report.${format}`, file);
    } catch (error) {
      if (!own.signal.aborted) studio.report("The report", error);
    } finally {
      setProgress(null);
    }
  };
  const count = oaks.filter((oak) => !oak.isHidden && studio.hasDepth(oak.state)).length;
  return (
    <Section title="Report" testId="report">
      <p class="hint">{`${count === 1 ? "The OAK" : `All ${count} OAKs`} by day and by night, stereo pairs by the matcher: a table with pictures. Print the page to make a PDF of it.`}</p>
      {progress === null ? (
        <div class="row">
          <Button label="Page (HTML)" class="primary" isDisabled={count === 0} onClick={() => void make("html")} testId="report-html" />
          <Button label="Table (CSV)" isDisabled={count === 0} onClick={() => void make("csv")} testId="report-csv" />
        </div>
      ) : (
        <div class="row" role="status"><span>{`Measured ${progress}…`}</span><Button label="Cancel" onClick={() => running.current?.abort()} /></div>
      )}
    </Section>
  );
}

/** Makes the page of a report, whose pictures share their scales. */
async function page(app: App, report: Made): Promise<Blob> {
  // By night, a pair without a projector measures at random: its errors would hide all others.
  const byDay = report.rows.filter(({ light }) => light === "day");
  const scales = findScales(byDay.map(({ frame }) => frame), app.studio.display.get());
  const pictures: Picture[][] = [];
  for (const row of report.rows) pictures.push(await Promise.all(KINDS.map((kind) => picture(app, row, kind, scales))));
  return new Blob([reportHtml(report, pictures, app.studio.catalog.get().version)], { type: "text/html" });
}

async function picture(app: App, row: Row, kind: PanelKind, scales: ReturnType<typeof findScales>): Promise<Picture> {
  const png = await captionedFrame(app, "report", row.frame, kind, scales);
  const address = png ? await dataAddress(png) : "data:,";
  return { title: `${titleOf(kind)} of ${row.state.model} by ${row.light}`, address };
}

function dataAddress(blob: Blob): Promise<string> {
  return new Promise((resolve, reject) => {
    const reader = new FileReader();
    reader.onload = () => resolve(String(reader.result));
    reader.onerror = () => reject(reader.error ?? new Error("The picture cannot be read."));
    reader.readAsDataURL(blob);
  });
}
