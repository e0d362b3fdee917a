import {
  BufferAttribute, BufferGeometry, DataTexture, GLSL3, Matrix4, NearestFilter, Points, RawShaderMaterial, RedIntegerFormat, RGBAFormat,
  UnsignedByteType, UnsignedShortType, Vector2, Vector3,
} from "three";
import type { Picture } from "../net/wire";

/** Colours of points; the numbers are those of the shader. */
export const CLOUD_MODES = { depth: 0, error: 1, reason: 2, oak: 3 } as const;

export interface CloudInput {
  /** The depth that places the points. */
  depth: Picture;
  truth: Picture | undefined;
  measured: Picture | undefined;
  reasons: Picture | undefined;
  hfovDeg: number;
  vfovDeg: number;
  mode: keyof typeof CLOUD_MODES;
  /** RGBA, 256 entries. */
  table: Uint8Array<ArrayBuffer>;
  range: [number, number];
  isRelative: boolean;
  /** From 0 to 1. */
  color: [number, number, number];
  pointSize: number;
  /** Clouds with more points are thinned. */
  maxPoints: number;
}

const VERTEX = `
precision highp float;
precision highp int;
precision highp usampler2D;
uniform mat4 modelViewMatrix;
uniform mat4 projectionMatrix;
uniform usampler2D depth;
uniform usampler2D truth;
uniform usampler2D measured;
uniform usampler2D reasons;
uniform sampler2D table;
uniform vec2 tangent;
uniform vec2 range;
uniform int mode;
uniform int stride;
uniform bool isRelative;
uniform vec3 color;
uniform float pointSize;
in float unused;
out vec3 shade;

vec3 lookUp(float from0to1) {
  return texture(table, vec2((clamp(from0to1, 0.0, 1.0) * 255.0 + 0.5) / 256.0, 0.5)).rgb;
}

void main() {
  ivec2 size = textureSize(depth, 0);
  int columns = size.x / stride;
  ivec2 pixel = ivec2(gl_VertexID % columns, gl_VertexID / columns) * stride;
  uint value = texelFetch(depth, pixel, 0).r;
  float z = float(value) * 0.001;
  vec2 place = (vec2(pixel) + 0.5) / vec2(size) * 2.0 - 1.0;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(place * tangent * z, z, 1.0);
  gl_PointSize = pointSize;
  shade = color;
  bool isDropped = value == 0u;
  if (mode == 0) {
    shade = lookUp((z - range.x) / max(range.y - range.x, 1e-6));
  } else if (mode == 1) {
    uint exact = texelFetch(truth, pixel, 0).r;
    uint found = texelFetch(measured, pixel, 0).r;
    float error = (float(found) - float(exact)) * 0.001;
    if (isRelative) error *= 100.0 / max(float(exact) * 0.001, 1e-3);
    shade = found == 0u ? vec3(0.42) : lookUp(0.5 + 0.5 * error / max(range.y, 1e-9));
    isDropped = isDropped || exact == 0u;
  } else if (mode == 2) {
    shade = texelFetch(table, ivec2(int(texelFetch(reasons, pixel, 0).r), 0), 0).rgb;
  }
  if (isDropped) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
}`;

const FRAGMENT = `
precision highp float;
in vec3 shade;
out vec4 result;
void main() {
  result = vec4(shade, 1.0);
}`;

function integers(picture: Picture): DataTexture {
  const isShort = picture.format === "u16mm";
  const texture = new DataTexture(picture.data, picture.width, picture.height, RedIntegerFormat, isShort ? UnsignedShortType : UnsignedByteType);
  texture.internalFormat = isShort ? "R16UI" : "R8UI";
  texture.minFilter = texture.magFilter = NearestFilter;
  texture.unpackAlignment = 1;
  texture.needsUpdate = true;
  return texture;
}

/** Points in an optical frame, placed by a depth image in the vertex shader. */
export function makeCloud(input: CloudInput): Points<BufferGeometry, RawShaderMaterial> {
  const { width, height } = input.depth;
  const stride = Math.max(1, Math.ceil(Math.sqrt((width * height) / input.maxPoints)));
  const count = Math.floor(width / stride) * Math.floor(height / stride);
  const geometry = new BufferGeometry();
  // The shader places the points by their number; three.js takes that number from an attribute.
  geometry.setAttribute("unused", new BufferAttribute(new Uint8Array(count), 1));
  geometry.setDrawRange(0, count);
  const textures = new Map<Picture, DataTexture>();
  const texture = (picture: Picture | undefined) => {
    const shown = picture ?? input.depth;
    const known = textures.get(shown) ?? integers(shown);
    textures.set(shown, known);
    return known;
  };
  const table = new DataTexture(input.table, input.table.length / 4, 1, RGBAFormat, UnsignedByteType);
  table.needsUpdate = true;
  const tangent = (degrees: number) => Math.tan((degrees * Math.PI) / 360);
  const material = new RawShaderMaterial({
    glslVersion: GLSL3,
    vertexShader: VERTEX,
    fragmentShader: FRAGMENT,
    uniforms: {
      depth: { value: texture(input.depth) },
      truth: { value: texture(input.truth) },
      measured: { value: texture(input.measured) },
      reasons: { value: texture(input.reasons) },
      table: { value: table },
      tangent: { value: new Vector2(tangent(input.hfovDeg), tangent(input.vfovDeg)) },
      range: { value: new Vector2(...input.range) },
      mode: { value: CLOUD_MODES[input.mode] },
      stride: { value: stride },
      isRelative: { value: input.isRelative },
      color: { value: new Vector3(...input.color) },
      pointSize: { value: input.pointSize },
    },
  });
  material.addEventListener("dispose", () => {
    for (const one of textures.values()) one.dispose();
    table.dispose();
  });
  const points = new Points(geometry, material);
  points.frustumCulled = false;
  points.matrixAutoUpdate = false;
  return points;
}

/** Draws a cloud over the rest of the scene, which would hide what lies behind its surfaces. */
export function showThrough(points: Points<BufferGeometry, RawShaderMaterial>): void {
  points.material.depthTest = false;
  points.renderOrder = 1;
}

/** Places a cloud by the pose of its body and the camera in that body. */
export function placeCloud(points: Points, worldFromBody: Matrix4, bodyFromCamera: Matrix4): void {
  points.matrix.multiplyMatrices(worldFromBody, bodyFromCamera);
  points.matrixWorldNeedsUpdate = true;
}
