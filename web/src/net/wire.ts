import type { FrameHeader, ImageHeader, ImageName, MeshHeader } from "../protocol";
import { decodeLz4 } from "./lz4";

/** A decoded image of a frame. */
export interface Picture {
  name: ImageName;
  width: number;
  height: number;
  format: ImageHeader["format"];
  /** Millimetres for `u16mm`, otherwise bytes. */
  data: Uint8Array<ArrayBuffer> | Uint16Array<ArrayBuffer>;
}

/** What the server sent for one OAK. */
export interface Frame {
  header: FrameHeader;
  pictures: ReadonlyMap<ImageName, Picture>;
}

/** A triangle mesh; see {@link MeshHeader}. */
export interface Mesh {
  header: MeshHeader;
  positions: Float32Array<ArrayBuffer>;
  /** sRGB with alpha. */
  colors: Uint8Array<ArrayBuffer>;
  indices: Uint32Array<ArrayBuffer>;
  /** For each triangle. */
  objects: Uint32Array<ArrayBuffer>;
}

const BYTES_PER_PIXEL = { rgba8: 4, u16mm: 2, u8: 1 };

/** Splits a binary message into its JSON header and the place where its data begins. */
export function header<T>(message: ArrayBuffer): [T, number] {
  const length = new DataView(message).getUint32(0, true);
  const text = new TextDecoder().decode(new Uint8Array(message, 4, length));
  return [JSON.parse(text) as T, 4 + length];
}

/** Decodes a frame; `before` are the last images of the same OAK by name, which unchanged ones are taken from. */
export function decodeFrame(message: ArrayBuffer, before: (oak: string) => ReadonlyMap<ImageName, Picture> | undefined): Frame {
  const [parsed, start] = header<FrameHeader>(message);
  const pictures = new Map<ImageName, Picture>();
  for (const image of parsed.images) {
    const { name, width, height, format } = image;
    if (image.unchanged) {
      const known = before(parsed.oak)?.get(name);
      if (known) pictures.set(name, known);
      continue;
    }
    const block = new Uint8Array(message, start + image.offset, image.length);
    const bytes = decodeLz4(block, width * height * BYTES_PER_PIXEL[format]);
    const data = format === "u16mm" ? new Uint16Array(bytes.buffer) : bytes;
    pictures.set(name, { name, width, height, format, data });
  }
  return { header: parsed, pictures };
}

export function decodeMesh(message: ArrayBuffer): Mesh {
  const [parsed, end] = header<MeshHeader>(message);
  const { vertices, triangles } = parsed;
  let offset = Math.ceil(end / 4) * 4;
  const next = (bytes: number): number => {
    const start = offset;
    offset += bytes;
    return start;
  };
  return {
    header: parsed,
    positions: new Float32Array(message, next(vertices * 12), vertices * 3),
    colors: new Uint8Array(message, next(vertices * 4), vertices * 4),
    indices: new Uint32Array(message, next(triangles * 12), triangles * 3),
    objects: new Uint32Array(message, next(triangles * 4), triangles),
  };
}
