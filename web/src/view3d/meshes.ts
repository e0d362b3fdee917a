import { BufferAttribute, BufferGeometry, DoubleSide, FrontSide, Mesh as ThreeMesh, MeshLambertMaterial } from "three";
import type { Mesh } from "../net/wire";

/** Linear values by sRGB byte: three.js expects linear vertex colours. */
const LINEAR = Float32Array.from({ length: 256 }, (_, byte) => {
  const value = byte / 255;
  return value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4;
});

/** Makes a mesh that is painted onto a surface: `color` is that of a number in the place of a triangle's object. */
export function makePainting(mesh: Mesh, color: (object: number) => readonly [number, number, number]): ThreeMesh<BufferGeometry, MeshLambertMaterial> {
  const colors = new Uint8Array(mesh.header.vertices * 4);
  // Triangles share a vertex only if they have the same number.
  mesh.indices.forEach((vertex, i) => colors.set(color(mesh.objects[Math.floor(i / 3)] ?? 0), vertex * 4));
  const painting = makeMesh({ ...mesh, colors }, false);
  painting.material.polygonOffset = true;
  painting.material.polygonOffsetFactor = -2;
  painting.material.polygonOffsetUnits = -4;
  return painting;
}

/** Makes a mesh to draw. Faces are shaded flat, so that no normals are needed. */
export function makeMesh(mesh: Mesh, isTwoSided: boolean): ThreeMesh<BufferGeometry, MeshLambertMaterial> {
  const geometry = new BufferGeometry();
  const { vertices } = mesh.header;
  const colors = new Float32Array(vertices * 3);
  for (let i = 0; i < vertices; i++) {
    for (let channel = 0; channel < 3; channel++) colors[i * 3 + channel] = LINEAR[mesh.colors[i * 4 + channel] ?? 0] ?? 0;
  }
  geometry.setAttribute("position", new BufferAttribute(mesh.positions, 3));
  geometry.setAttribute("color", new BufferAttribute(colors, 3));
  geometry.setIndex(new BufferAttribute(mesh.indices, 1));
  geometry.computeBoundingSphere();
  const side = isTwoSided ? DoubleSide : FrontSide;
  return new ThreeMesh(geometry, new MeshLambertMaterial({ vertexColors: true, flatShading: true, side }));
}
