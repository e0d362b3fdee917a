/** The height of a panel's caption, and the gap between panels in CSS pixels; as in images.css. */
const CAPTION_REM = 1.7;
export const GAP = 6;
/** The least width of an image of a grid, and of a thumbnail. */
const MIN_WIDTH = 120;
const MIN_THUMBNAIL = 84;
/** How much an arrangement counts whose thumbnails do not fit. */
const OVERFLOW_WEIGHT = 0.01;
/** How much the area of thumbnails counts beside that of the large images. */
const THUMBNAILS_WEIGHT = 0.35;
/** The shares of the width or the height that thumbnails can have. */
const SHARES = Array.from({ length: 19 }, (_, i) => 0.1 + 0.02 * i);

/** A number of columns, and the width of an image in CSS pixels. */
export interface Columns {
  count: number;
  width: number;
}

function captionHeight(): number {
  return CAPTION_REM * Number.parseFloat(getComputedStyle(document.documentElement).fontSize);
}

function largest(width: number, height: number, aspect: number, total: number, choices: number[]): Columns {
  const caption = captionHeight();
  let best = { count: 1, width: 0 };
  for (const count of choices) {
    const rows = Math.ceil(total / count);
    const fits = Math.min((width - GAP * (count - 1)) / count, ((height - GAP * (rows - 1)) / rows - caption) * aspect);
    if (fits > best.width) best = { count, width: fits };
  }
  return { count: best.count, width: Math.floor(best.width) };
}

const upTo = (total: number) => Array.from({ length: total }, (_, i) => i + 1);

/** Finds the number of columns with the largest panels; with several OAKs and images, those of one OAK are in one row or column. */
export function grid(width: number, height: number, aspect: number, oaks: number, kinds: number): Columns {
  const total = oaks * kinds;
  const found = largest(width, height, aspect, total, oaks > 1 && kinds > 1 ? [kinds, oaks] : upTo(total));
  return { ...found, width: Math.max(MIN_WIDTH, found.width) };
}

/** Large images with thumbnails beside or below them. */
export interface Focused {
  large: Columns;
  thumbnails: Columns;
  areBeside: boolean;
}

/** Finds the arrangement of large images and thumbnails that uses the space best. */
export function focused(width: number, height: number, aspect: number, large: number, thumbnails: number): Focused {
  if (thumbnails === 0) {
    const found = largest(width, height, aspect, large, upTo(large));
    return { large: { ...found, width: Math.max(MIN_WIDTH, found.width) }, thumbnails: { count: 1, width: MIN_THUMBNAIL }, areBeside: true };
  }
  let best: Focused | null = null;
  let most = -1;
  for (const areBeside of [true, false]) {
    for (const share of SHARES) {
      const [rest, small] = areBeside ? [width * (1 - share) - GAP, width * share] : [height * (1 - share) - GAP, height * share];
      const one = largest(areBeside ? rest : width, areBeside ? height : rest, aspect, large, upTo(large));
      const others = largest(areBeside ? small : width, areBeside ? height : small, aspect, thumbnails, upTo(thumbnails));
      // Thumbnails are not larger than the images that they belong to.
      const shown = Math.min(others.width, one.width);
      const fits = shown >= MIN_THUMBNAIL && one.width >= MIN_WIDTH;
      const area = (one.width ** 2 * large + THUMBNAILS_WEIGHT * shown ** 2 * thumbnails) * (fits ? 1 : OVERFLOW_WEIGHT);
      if (area <= most) continue;
      most = area;
      best = { large: one, thumbnails: { count: others.count, width: shown }, areBeside };
    }
  }
  const found = best as unknown as Focused;
  const atLeast = ({ count, width }: Columns, least: number) => ({ count, width: Math.max(least, width) });
  return { ...found, large: atLeast(found.large, MIN_WIDTH), thumbnails: atLeast(found.thumbnails, MIN_THUMBNAIL) };
}
