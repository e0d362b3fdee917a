import { css, oakColor } from "../gpu/colormaps";
import { unbroken } from "../util/format";

/** The heading of an OAK's column: a dot in its colour and, if there is room, its model. */
export function ColumnName({ index, model, isShort }: { index: number; model: string; isShort: boolean }) {
  return (
    <span class="column-name">
      <span class="dot-small" style={{ background: css(oakColor(Math.max(index, 0))) }} />
      <span class={isShort ? "sr-only" : ""}>{unbroken(model)}</span>
    </span>
  );
}
