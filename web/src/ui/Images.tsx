import { useLayoutEffect, useRef, useState } from "preact/hooks";
import type { Scales } from "../gpu/scales";
import { type Display, type PanelKind, shownKinds } from "../state/display";
import type { Oak } from "../state/document";
import { useStore } from "../util/store";
import { focused, grid } from "./arrangement";
import { ComparisonPanel } from "./ComparisonPanel";
import { useApp } from "./context";
import { ImageBar } from "./ImageBar";
import { Legend } from "./Legend";
import { aspectOf, Panel } from "./Panel";
import { useScales } from "./scales";

/** The space around the panels, CSS pixels; as in images.css. */
const PADDING = { width: 16, height: 12 };

interface Size {
  width: number;
  height: number;
}

interface Shared {
  /** The OAKs that are shown, with their places in the list of all. */
  shown: { oak: Oak; index: number }[];
  /** The OAK whose images are the thumbnails. */
  selected: string;
  kinds: PanelKind[];
  size: Size;
  /** The narrowest aspect ratio of the images. */
  aspect: number;
  scales: Scales;
}

/** The images of all OAKs, with the choice of what they show. */
export function Images() {
  const { studio } = useApp();
  const display = useStore(studio.display);
  const frames = useStore(studio.frames);
  const { oaks, selected } = useStore(studio.document);
  const maximized = useStore(studio.maximized);
  const scales = useScales(frames, display);
  const area = useRef<HTMLDivElement>(null);
  const [size, setSize] = useState({ width: 800, height: 300 });
  useLayoutEffect(() => {
    const element = area.current;
    if (!element) return;
    const observer = new ResizeObserver(() => setSize({ width: element.clientWidth - PADDING.width, height: element.clientHeight - PADDING.height }));
    observer.observe(element);
    return () => observer.disconnect();
  }, []);
  const all = oaks.map((oak, index) => ({ oak, index })).filter(({ oak }) => !oak.isHidden);
  const kinds = shownKinds(display);
  const only = maximized && all.find(({ oak }) => oak.key === maximized.oak);
  const aspects = (only ? [only] : all).map(({ oak }) => frames.get(oak.key)).filter((frame) => frame !== undefined).map(aspectOf);
  const shared: Shared = {
    shown: only ? [only] : all,
    selected,
    kinds: only ? [maximized.kind] : kinds,
    size,
    aspect: Math.min(...(aspects.length ? aspects : [aspectOf(undefined)])),
    scales,
  };
  const { comparison } = display;
  const isEmpty = all.length === 0 || kinds.length === 0;
  return (
    <section class={`images ${only ? "maximized" : ""}`} aria-label="Images">
      <ImageBar />
      <div class="panels" ref={area}>
        {comparison && <ComparisonPanel comparison={comparison} size={size} scales={scales} />}
        {!comparison && !isEmpty && (display.arrangement === "grid" && !only ? <Grid {...shared} /> : <Large {...shared} focus={only ? maximized.kind : display.focus} />)}
        {!comparison && isEmpty && <p class="hint pad">{all.length === 0 ? "All OAKs are hidden." : "Choose at least one image above."}</p>}
      </div>
      <Legend kinds={[...shared.kinds, ...cloudKinds(display)]} scales={scales} />
    </section>
  );
}

/** All images in one size. */
function Grid({ shown, kinds, size, aspect, scales }: Shared) {
  const layout = grid(size.width, size.height, aspect, shown.length, kinds.length);
  // In a grid by images, all OAKs of an image follow each other.
  const isByKind = shown.length > 1 && kinds.length > 1 && layout.count === shown.length && layout.count !== kinds.length;
  const cells = isByKind
    ? kinds.flatMap((kind) => shown.map((one) => ({ ...one, kind })))
    : shown.flatMap((one) => kinds.map((kind) => ({ ...one, kind })));
  return (
    <div class="grid" style={{ gridTemplateColumns: `repeat(${layout.count}, ${layout.width}px)` }}>
      {cells.map(({ oak, index, kind }) => (
        <Panel key={`${oak.key}/${kind}`} oak={oak} index={index} kind={kind} width={layout.width} scales={scales} />
      ))}
    </div>
  );
}

/** One image of each OAK, and the other images of the selected one as thumbnails. */
function Large({ shown, selected, kinds, size, aspect, scales, focus: wanted }: Shared & { focus: PanelKind }) {
  const focus = kinds.includes(wanted) ? wanted : (kinds[0] ?? wanted);
  const small = shown.find(({ oak }) => oak.key === selected) ?? shown[0];
  const others = kinds.filter((kind) => kind !== focus);
  const { large, thumbnails, areBeside } = focused(size.width, size.height, aspect, shown.length, others.length);
  return (
    <div class={`focused ${areBeside ? "beside" : "below"}`}>
      <div class="grid" style={{ gridTemplateColumns: `repeat(${large.count}, ${large.width}px)` }}>
        {shown.map(({ oak, index }) => (
          <Panel key={`${oak.key}/${focus}`} oak={oak} index={index} kind={focus} width={large.width} scales={scales} isNamedByOak={shown.length > 1} />
        ))}
      </div>
      {small && others.length > 0 && (
        <div class="grid" style={{ gridTemplateColumns: `repeat(${thumbnails.count}, ${thumbnails.width}px)` }} data-testid="thumbnails">
          {others.map((kind) => (
            <Panel key={`${small.oak.key}/${kind}`} oak={small.oak} index={small.index} kind={kind} width={thumbnails.width} scales={scales} isThumbnail />
          ))}
        </div>
      )}
    </div>
  );
}

/** Returns the images whose colours the points in the 3D view have. */
function cloudKinds({ cloud, cloudColor }: Display): PanelKind[] {
  return cloud === "none" || cloudColor === "oak" ? [] : [cloudColor];
}
