// Meshes: a part of `protocol.ts`.
import type { Vec3 } from "./protocol";

/**
 * A binary mesh: 4 bytes, the length N of the JSON in little endian; N bytes of JSON, which is this header; padding with zeros to a
 * multiple of 4; then float32 positions (3 per vertex), uint8 sRGB colours with alpha (4 per vertex), uint32 indices (3 per
 * triangle), and for each triangle the uint32 index of its object in `SceneInfo.objects`. All little endian.
 */
export interface MeshHeader {
  vertices: number;
  triangles: number;
  /** The number of triangles of the full scene. */
  ofTriangles: number;
}

/**
 * Binary surfaces with textures, over those of the mesh; none if there are too many. Laid out like a mesh: after the header and its
 * padding, for each group the float32 positions (3 per vertex) and coordinates (2 per vertex) of its triangles' corners; then the rgba8
 * pixels of the textures, the lowest row first.
 */
export interface TexturedHeader {
  /** The colour is the linear factor of the texture. */
  groups: { vertices: number; texture: number; color: Vec3 }[];
  textures: { width: number; height: number; wrap: [TextureWrap, TextureWrap] }[];
}

export type TextureWrap = "repeat" | "mirror" | "clamp";
