import type { TexturedHeader, TextureWrap, Vec3 } from "../protocol";
import { header } from "./wire";

/** Surfaces with textures; see {@link TexturedHeader}. */
export interface Textured {
  groups: { positions: Float32Array<ArrayBuffer>; coordinates: Float32Array<ArrayBuffer>; texture: number; color: Vec3 }[];
  textures: { width: number; height: number; wrap: [TextureWrap, TextureWrap]; pixels: Uint8Array<ArrayBuffer> }[];
}

export function decodeTextured(message: ArrayBuffer): Textured {
  const [parsed, end] = header<TexturedHeader>(message);
  let offset = Math.ceil(end / 4) * 4;
  const next = (bytes: number): number => {
    offset += bytes;
    return offset - bytes;
  };
  const groups = parsed.groups.map(({ vertices, texture, color }) => ({
    positions: new Float32Array(message, next(vertices * 12), vertices * 3),
    coordinates: new Float32Array(message, next(vertices * 8), vertices * 2),
    texture,
    color,
  }));
  const textures = parsed.textures.map((texture) => {
    const bytes = texture.width * texture.height * 4;
    return { ...texture, pixels: new Uint8Array(message, next(bytes), bytes) };
  });
  return { groups, textures };
}
