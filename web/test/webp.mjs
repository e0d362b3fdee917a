// Writes animated WebP files from still ones, after the container's specification (RFC 9649).

/** Returns a chunk: its name, the length of its data, the data, and a zero if the length is odd. */
function chunk(name, ...parts) {
  const data = Buffer.concat(parts);
  const head = Buffer.alloc(8);
  head.write(name, "latin1");
  head.writeUInt32LE(data.length, 4);
  return Buffer.concat([head, data, Buffer.alloc(data.length % 2)]);
}

function numbers(...values) {
  return Buffer.concat(values.map((value) => {
    const three = Buffer.alloc(3);
    three.writeUIntLE(value, 0, 3);
    return three;
  }));
}

/** Returns the chunk with the picture of a lossy file without alpha. */
function picture(file) {
  for (let at = 12; at + 8 <= file.length;) {
    const length = file.readUInt32LE(at + 4);
    const end = at + 8 + length + (length % 2);
    if (file.toString("latin1", at, at + 4) === "VP8 ") return file.subarray(at, end);
    at = end;
  }
  throw new Error("the browser made no lossy WebP file");
}

/**
 * Joins files; each frame is `{ file, milliseconds, place }` and replaces the rectangle `place`: left, top, width and height, of which the first two are even. It
 * repeats without end.
 */
export function animation(frames, width, height) {
  const hasAnimation = Buffer.from([0x02, 0, 0, 0]);
  const chunks = [
    chunk("VP8X", hasAnimation, numbers(width - 1, height - 1)),
    chunk("ANIM", Buffer.from([255, 255, 255, 255, 0, 0])),
    ...frames.map(({ file, milliseconds, place: [left, top, own, ownHeight] }) => {
      const isOpaque = Buffer.from([0x02]);
      return chunk("ANMF", numbers(left / 2, top / 2, own - 1, ownHeight - 1, milliseconds), isOpaque, picture(file));
    }),
  ];
  return chunk("RIFF", Buffer.from("WEBP", "latin1"), ...chunks);
}
