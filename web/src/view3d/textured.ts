import {
  BufferAttribute, BufferGeometry, ClampToEdgeWrapping, Color, DataTexture, Group, LinearFilter, LinearMipmapLinearFilter, Mesh, MeshLambertMaterial,
  MirroredRepeatWrapping, type Plane, RepeatWrapping, SRGBColorSpace, type Texture,
} from "three";
import type { Textured } from "../net/textured";

const WRAPS = { repeat: RepeatWrapping, mirror: MirroredRepeatWrapping, clamp: ClampToEdgeWrapping } as const;

/** Makes surfaces that are drawn over the same ones of a mesh without textures. Rays do not see them. */
export function makeTextured({ groups, textures }: Textured): Group {
  const made = textures.map(({ width, height, wrap: [s, t], pixels }): Texture => {
    const texture = new DataTexture(pixels, width, height);
    texture.colorSpace = SRGBColorSpace;
    [texture.wrapS, texture.wrapT] = [WRAPS[s], WRAPS[t]];
    [texture.magFilter, texture.minFilter] = [LinearFilter, LinearMipmapLinearFilter];
    texture.generateMipmaps = true;
    texture.anisotropy = 4;
    texture.needsUpdate = true;
    return texture;
  });
  const all = new Group();
  for (const { positions, coordinates, texture, color } of groups) {
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(positions, 3));
    geometry.setAttribute("uv", new BufferAttribute(coordinates, 2));
    const material = new MeshLambertMaterial({ map: made[texture] ?? null, color: new Color(...color), flatShading: true });
    material.polygonOffset = true;
    [material.polygonOffsetFactor, material.polygonOffsetUnits] = [-1, -1];
    const mesh = new Mesh(geometry, material);
    mesh.raycast = () => {};
    all.add(mesh);
  }
  return all;
}

/** Cuts the surfaces. */
export function clipTextured(group: Group, planes: Plane[] | null): void {
  for (const { material } of group.children as Mesh<BufferGeometry, MeshLambertMaterial>[]) material.clippingPlanes = planes;
}

/** Frees the textures, which belong to no material alone. */
export function forgetTextures(group: Group): void {
  for (const { material } of group.children as Mesh<BufferGeometry, MeshLambertMaterial>[]) material.map?.dispose();
}
