/** Thrown if a block is damaged or does not have the expected length. */
export class Lz4Error extends Error {}

/** Copies that are shorter than this are faster as a loop than as a call. */
const SHORT = 24;

/**
 * Decodes an LZ4 block.
 *
 * A block is a sequence of tokens. The upper half of a token is a number of literal bytes, the lower half is the length of a copy
 * of earlier output minus 4; 15 in either means that bytes follow that add to it, up to and including the first below 255. The
 * last token has no copy.
 */
export function decodeLz4(source: Uint8Array, length: number): Uint8Array<ArrayBuffer> {
  const output = new Uint8Array(length);
  let from = 0;
  let to = 0;
  const extended = (count: number): number => {
    let more = count === 15 ? 255 : 0;
    while (more === 255) {
      more = source[from++] ?? 0;
      count += more;
    }
    return count;
  };
  while (from < source.length) {
    const token = source[from++] as number;
    const literals = extended(token >> 4);
    if (from + literals > source.length || to + literals > length) throw new Lz4Error("The literals exceed the block.");
    if (literals < SHORT) for (let i = 0; i < literals; i++) output[to + i] = source[from + i] as number;
    else output.set(source.subarray(from, from + literals), to);
    from += literals;
    to += literals;
    if (from >= source.length) break;
    const distance = (source[from] as number) | ((source[from + 1] ?? 0) << 8);
    from += 2;
    const copied = extended(token & 15) + 4;
    if (distance === 0 || distance > to || to + copied > length) throw new Lz4Error("A copy exceeds the output.");
    copyWithin(output, to, distance, copied);
    to += copied;
  }
  if (to !== length) throw new Lz4Error(`The block has ${to} bytes instead of ${length}.`);
  return output;
}

/** Repeats output from `distance` bytes before; the source may overlap the copy, which then repeats a pattern. */
function copyWithin(output: Uint8Array, to: number, distance: number, count: number): void {
  if (count < SHORT) {
    for (let i = 0; i < count; i++) output[to + i] = output[to + i - distance] as number;
    return;
  }
  let done = Math.min(distance, count);
  output.copyWithin(to, to - distance, to - distance + done);
  // Each pass doubles the repeated pattern.
  while (done < count) {
    const more = Math.min(done, count - done);
    output.copyWithin(to + done, to, to + more);
    done += more;
  }
}
