import { css, oakColor } from "../gpu/colormaps";
import type { Scales } from "../gpu/scales";
import { type PanelKind, PANELS } from "../state/display";
import type { Oak } from "../state/document";
import type { Shown } from "../studio/studio";
import { share, signedMillimetres, unbroken } from "../util/format";
import { useSelected } from "../util/store";
import { useApp } from "./context";
import { Marks } from "./Marks";
import { Picture } from "./Picture";
import { Surface } from "./Surface";

interface Props {
  oak: Oak;
  index: number;
  kind: PanelKind;
  /** CSS pixels. */
  width: number;
  scales: Scales;
  /** Whether a click makes it the large image; otherwise a double click maximizes it. */
  isThumbnail?: boolean;
  /** Whether the OAK is what tells it from its neighbours. */
  isNamedByOak?: boolean;
}

export function titleOf(kind: PanelKind): string {
  return PANELS.find((panel) => panel.kind === kind)?.title ?? kind;
}

/** One image of one OAK. */
export function Panel({ oak, index, kind, width, scales, isThumbnail = false, isNamedByOak = false }: Props) {
  const { studio } = useApp();
  const frame = useSelected(studio.frames, (frames) => frames.get(oak.key));
  const rejection = useSelected(studio.rejections, (rejections) => rejections.get(oak.key));
  const height = Math.round(width / aspectOf(frame));
  const choose = () => {
    if (isThumbnail) studio.show({ focus: kind });
    else studio.maximized.update((now) => (now ? null : { oak: oak.key, kind }));
  };
  return (
    <figure class={`panel ${rejection && frame ? "stale" : ""}`} data-testid={`panel-${oak.key}-${kind}`}>
      <figcaption class={isThumbnail ? "thumbnail-name" : ""}>
        <span class="dot-small" style={{ background: css(oakColor(index)) }} />
        <span class="panel-title">{isNamedByOak ? unbroken(oak.state.model) : titleOf(kind)}</span>
        {!isThumbnail && <span class="panel-oak">{isNamedByOak ? titleOf(kind) : oak.state.model}</span>}
        <span class="spring" />
        {frame && <span class={`panel-fact ${frame.isPreview ? "provisional" : ""}`}>{fact(kind, frame)}</span>}
        {frame && !isThumbnail && <Fineness frame={frame} />}
      </figcaption>
      <Surface oak={oak.key} label={`${titleOf(kind)} of ${oak.state.model}`} width={width} height={height} isZoomed={!isThumbnail} onChoose={choose} isChosenByClick={isThumbnail}>
        <Picture oak={oak.key} kind={kind} frame={frame} width={width} height={height} isZoomed={!isThumbnail} scales={scales} />
        <Marks oak={oak.key} kind={kind} isZoomed={!isThumbnail} />
        <StateOf oak={oak} />
      </Surface>
    </figure>
  );
}

/** Why the image of an OAK is not there, or not up to date. */
export function StateOf({ oak }: { oak: Oak }) {
  const { studio } = useApp();
  const frame = useSelected(studio.frames, (frames) => frames.get(oak.key));
  const rejection = useSelected(studio.rejections, (rejections) => rejections.get(oak.key));
  if (frame) return rejection ? <p class="stale-note">{`Not measured: ${rejection.error}`}</p> : null;
  return <p class="empty">{emptyText(rejection?.error, studio.hasDepth(oak.state), oak.state.model)}</p>;
}

/** Whether an image is a preview, and its size. */
export function Fineness({ frame }: { frame: Shown }) {
  const picture = frame.pictures.get("sensor");
  if (!picture) return null;
  const size = `${picture.width} × ${picture.height}`;
  return frame.isPreview
    ? <span class="fineness preview" data-testid="fineness" data-tip="Coarse while something changes; the final image follows">{`preview ${size}`}</span>
    : <span class="fineness" data-testid="fineness">{size}</span>;
}

function emptyText(error: string | undefined, hasDepth: boolean, model: string): string {
  if (error) return error;
  return hasDepth ? "Measuring…" : `${model} has no depth sensor.`;
}

export function aspectOf(frame: Shown | undefined): number {
  const picture = frame?.pictures.get("sensor") ?? [...(frame?.pictures.values() ?? [])][0];
  return picture ? picture.width / picture.height : 1.6;
}

/** The number that says most about an image. */
function fact(kind: PanelKind, { header: { statistics } }: Shown): string {
  if (kind === "sensor" || kind === "reason") return `${share(statistics.fillRate)} filled`;
  if (kind === "error") return `median ${signedMillimetres(statistics.medianErrorM)}`;
  return "";
}
