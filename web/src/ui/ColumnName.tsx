import { css, oakColor } from "../gpu/colormaps";
import { unbroken } from "../util/format";

/** The heading of an OAK's column: a dot in its colour and its model, upwards if the column is narrow. */
export function ColumnName({ index, model, isNarrow }: { index: number; model: string; isNarrow: boolean }) {
  return (
    <span class={`column-name ${isNarrow ? "upright" : ""}`}>
      <span class="dot-small" style={{ background: css(oakColor(Math.max(index, 0))) }} />
      <span>{unbroken(model)}</span>
    </span>
  );
}

/** The heading of a narrow column. */
export function Heading({ name, tip }: { name: string; tip?: string }) {
  return <th scope="col" data-tip={tip}><span class="column-name upright">{name}</span></th>;
}
