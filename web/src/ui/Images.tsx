import { useLayoutEffect, useMemo, useRef, useState } from "preact/hooks";
import { findScales } from "../gpu/scales";
import { type Display, FULL_SIZES, type PanelKind, PANELS } from "../state/display";
import type { Oak } from "../state/document";
import { useStore } from "../util/store";
import { Button, Select } from "./controls";
import { useApp } from "./context";
import { Legend } from "./Legend";
import { Panel } from "./Panel";

/** The height of a panel's caption, and the gap between panels in CSS pixels; as in images.css. */
const CAPTION_REM = 1.7;
const GAP = 6;
/** The aspect ratio of an image that is not there yet. */
const ASPECT = 1.6;
const MIN_WIDTH = 150;

/** Finds the number of columns with the largest panels; with several OAKs and images, those of one OAK are in one row or column. */
export function columns(width: number, height: number, aspect: number, oaks: number, kinds: number): { count: number; width: number } {
  const total = oaks * kinds;
  const choices = oaks > 1 && kinds > 1 ? [kinds, oaks] : Array.from({ length: total }, (_, i) => i + 1);
  const caption = CAPTION_REM * Number.parseFloat(getComputedStyle(document.documentElement).fontSize);
  let best = { count: 1, width: 0 };
  for (const count of choices) {
    const rows = Math.ceil(total / count);
    const fits = Math.min((width - GAP * (count - 1)) / count, ((height - GAP * (rows - 1)) / rows - caption) * aspect);
    if (fits > best.width) best = { count, width: fits };
  }
  return { count: best.count, width: Math.max(MIN_WIDTH, Math.floor(best.width)) };
}

/** The images of all OAKs, with the choice of what they show. */
export function Images() {
  const { studio } = useApp();
  const display = useStore(studio.display);
  const frames = useStore(studio.frames);
  const { oaks } = useStore(studio.document);
  const shown = oaks.filter((oak) => !oak.isHidden);
  const scales = useMemo(() => findScales(frames.values(), display), [frames, display]);
  const kinds: PanelKind[] = display.wipe ? [display.wipe.left] : PANELS.map(({ kind }) => kind).filter((kind) => display.panels.includes(kind));
  const area = useRef<HTMLDivElement>(null);
  const [size, setSize] = useState({ width: 800, height: 300 });
  useLayoutEffect(() => {
    const element = area.current;
    if (!element) return;
    const observer = new ResizeObserver(() => setSize({ width: element.clientWidth - 16, height: element.clientHeight - 12 }));
    observer.observe(element);
    return () => observer.disconnect();
  }, []);
  const aspects = [...frames.values()].map(({ pictures }) => pictures.get("sensor")).map((picture) => (picture ? picture.width / picture.height : ASPECT));
  const aspect = aspects.length ? Math.min(...aspects) : ASPECT;
  const layout = columns(size.width, size.height, aspect, shown.length, Math.max(kinds.length, 1));
  // In a grid by images, all OAKs of an image follow each other.
  const isByKind = shown.length > 1 && kinds.length > 1 && layout.count === shown.length && layout.count !== kinds.length;
  const cells: [Oak, PanelKind][] = isByKind
    ? kinds.flatMap((kind) => shown.map((oak): [Oak, PanelKind] => [oak, kind]))
    : shown.flatMap((oak) => kinds.map((kind): [Oak, PanelKind] => [oak, kind]));
  return (
    <section class="images" aria-label="Images">
      <ImageBar />
      <div class="panels" ref={area}>
        <div class="grid" style={{ gridTemplateColumns: `repeat(${layout.count}, ${layout.width}px)` }}>
          {cells.map(([oak, kind]) => (
            <Panel
              key={`${oak.key}/${kind}`}
              oak={oak}
              index={oaks.indexOf(oak)}
              kind={kind}
              other={display.wipe?.right ?? null}
              width={layout.width}
              scales={scales}
            />
          ))}
        </div>
        {cells.length === 0 && <p class="hint pad">Choose at least one image above.</p>}
      </div>
      <Legend kinds={[...(display.wipe ? [display.wipe.left, display.wipe.right] : kinds), ...cloudKinds(display)]} scales={scales} />
    </section>
  );
}

/** Returns the images whose colours the points in the 3D view have. */
function cloudKinds({ cloud, cloudColor }: Display): PanelKind[] {
  return cloud === "none" || cloudColor === "oak" ? [] : [cloudColor];
}

function ImageBar() {
  const { studio } = useApp();
  const display = useStore(studio.display);
  const toggle = (kind: PanelKind) => {
    const panels = display.panels.includes(kind) ? display.panels.filter((other) => other !== kind) : [...display.panels, kind];
    studio.show({ panels });
  };
  const options = PANELS.map(({ kind, title }) => ({ value: kind, title }));
  const { wipe } = display;
  return (
    <div class="bar" role="toolbar" aria-label="Images that are shown">
      {wipe ? (
        <>
          <Select label="Left of the edge" isLabelled={false} value={wipe.left} options={options} onChange={(left) => studio.show({ wipe: { ...wipe, left } })} />
          <input
            type="range"
            class="wipe-at"
            min={0}
            max={1}
            step={0.01}
            aria-label="Edge of the wipe"
            value={display.wipeAt}
            onInput={(event) => studio.show({ wipeAt: Number(event.currentTarget.value) })}
          />
          <Select label="Right of the edge" isLabelled={false} value={wipe.right} options={options} onChange={(right) => studio.show({ wipe: { ...wipe, right } })} />
        </>
      ) : (
        PANELS.map(({ kind, title, help }) => (
          <Button key={kind} label={title} class="chip" tip={help} isOn={display.panels.includes(kind)} onClick={() => toggle(kind)} testId={`show-${kind}`} />
        ))
      )}
      <span class="spring" />
      <Button
        label="Wipe"
        class="chip"
        tip="Two images in one panel with a movable edge"
        isOn={wipe !== null}
        onClick={() => studio.show({ wipe: wipe ? null : { left: "depth", right: "sensor" } })}
      />
      <Select
        label="Image size at rest"
        isLabelled={false}
        value={display.fullSize}
        options={FULL_SIZES.map(({ size, title }) => ({ value: size, title }))}
        onChange={(fullSize) => studio.show({ fullSize })}
        testId="full-size"
      />
    </div>
  );
}
