/** An enlargement of an image: the factor, and the left top corner of the shown part as fractions of the image. */
export interface Zoom {
  scale: number;
  x: number;
  y: number;
}

export const NO_ZOOM: Zoom = { scale: 1, x: 0, y: 0 };

const LARGEST = 64;

/** Changes the scale so that a place, as fractions of what is shown, stays where it is. */
export function zoomed({ scale, x, y }: Zoom, factor: number, [atX, atY]: [number, number]): Zoom {
  const next = Math.max(1, Math.min(LARGEST, scale * factor));
  return panned({ scale: next, x: x + atX / scale - atX / next, y: y + atY / scale - atY / next }, 0, 0);
}

/** Moves the shown part by fractions of what is shown, within the image. */
export function panned({ scale, x, y }: Zoom, right: number, down: number): Zoom {
  const inside = (value: number) => Math.max(0, Math.min(1 - 1 / scale, value));
  const next = { scale, x: inside(x + right / scale), y: inside(y + down / scale) };
  return scale === 1 ? NO_ZOOM : next;
}
