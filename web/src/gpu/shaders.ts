/** One triangle that covers the target; `place` runs from the top left. */
export const VERTEX = `#version 300 es
out vec2 place;
void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0;
  place = vec2(corner.x, 1.0 - corner.y);
  gl_Position = vec4(corner * 2.0 - 1.0, 0.0, 1.0);
}`;

/**
 * Colours a part of an image. `mode` is {@link MODES}; millimetres become metres, 0 is no value.
 *
 * A pixel of the target that covers several pixels of the image has the mean of their colours. Among them, pixels without a value, and those
 * with a reason, have the square root of their share as their weight, so that small holes stay visible.
 */
export const FRAGMENT = `#version 300 es
precision highp float;
precision highp int;
precision highp usampler2D;
in vec2 place;
out vec4 color;
uniform int mode;
uniform usampler2D measured;
uniform usampler2D truth;
uniform sampler2D picture;
uniform sampler2D table;
uniform vec2 range;
uniform bool isRelative;
uniform vec3 empty[2];
// For the difference of two OAKs: the other one's images, its camera, both fields of view, and the colours of what only one measures.
uniform usampler2D otherMeasured;
uniform usampler2D otherTruth;
uniform mat4 otherFromThis;
uniform vec4 tangents;
uniform vec3 only[2];
// The shown part of the image: left, top, width and height as fractions.
uniform vec4 part;
// The pixels of the target.
uniform vec2 target;

// More pixels than this along an axis are not all read.
const int MOST = 16;

vec3 lookUp(float from0to1) {
  return texture(table, vec2((clamp(from0to1, 0.0, 1.0) * 255.0 + 0.5) / 256.0, 0.5)).rgb;
}

// Pixels without a value get a hatch, which no colour map has.
vec3 hatch() {
  return empty[int(mod(gl_FragCoord.x + gl_FragCoord.y, 8.0) < 2.0)];
}

uint at(usampler2D image, vec2 from0to1) {
  ivec2 size = textureSize(image, 0);
  return texelFetch(image, clamp(ivec2(from0to1 * vec2(size)), ivec2(0), size - 1), 0).r;
}

// By how much the other OAK's error at the same point of the surface is larger.
vec4 difference(uint value, vec2 from0to1, uint exact) {
  // What the other camera sees at the place may differ from the point by this share of its distance, or hides it.
  const float SAME = 0.03;
  float depth = float(exact) * 0.001;
  vec3 point = vec3((2.0 * from0to1 - 1.0) * tangents.xy, 1.0) * depth;
  vec3 there = (otherFromThis * vec4(point, 1.0)).xyz;
  vec2 seen = 0.5 + 0.5 * there.xy / (max(there.z, 1e-6) * tangents.zw);
  bool isSeen = exact != 0u && there.z > 0.0 && all(greaterThanEqual(seen, vec2(0.0))) && all(lessThan(seen, vec2(1.0)));
  uint otherExact = isSeen ? at(otherTruth, seen) : 0u;
  uint other = isSeen ? at(otherMeasured, seen) : 0u;
  if (abs(float(otherExact) * 0.001 - there.z) > SAME * there.z) other = 0u;
  if (exact == 0u || (value == 0u && other == 0u)) return vec4(hatch(), 1.0);
  if (other == 0u) return vec4(only[0], 0.0);
  if (value == 0u) return vec4(only[1], 0.0);
  float more = (abs(float(other) - float(otherExact)) - abs(float(value) - float(exact))) * 0.001;
  if (isRelative) more *= 100.0 / max(depth, 1e-3);
  return vec4(lookUp(0.5 + 0.5 * more / max(range.y, 1e-9)), 0.0);
}

// The colour of a pixel of the image, and whether it is one that must not vanish among others.
vec4 colorOf(ivec2 texel, vec2 size) {
  if (mode == 0) return vec4(texelFetch(picture, texel, 0).rgb, 0.0);
  uint value = texelFetch(measured, texel, 0).r;
  if (mode == 1) {
    if (value == 0u) return vec4(hatch(), 1.0);
    return vec4(lookUp((float(value) * 0.001 - range.x) / max(range.y - range.x, 1e-6)), 0.0);
  }
  if (mode == 2) {
    uint exact = at(truth, (vec2(texel) + 0.5) / size);
    if (value == 0u || exact == 0u) return vec4(hatch(), 1.0);
    float error = (float(value) - float(exact)) * 0.001;
    if (isRelative) error *= 100.0 / max(float(exact) * 0.001, 1e-3);
    return vec4(lookUp(0.5 + 0.5 * error / max(range.y, 1e-9)), 0.0);
  }
  if (mode == 6) {
    vec2 from0to1 = (vec2(texel) + 0.5) / size;
    return difference(value, from0to1, at(truth, from0to1));
  }
  if (mode == 3) return vec4(vec3(float(value) / 255.0), 0.0);
  if (mode == 4) return vec4(texelFetch(table, ivec2(int(value), 0), 0).rgb, value == 0u ? 0.0 : 1.0);
  return vec4(lookUp(float(value) / 255.0), 0.0);
}

void main() {
  vec2 size = vec2(mode == 0 ? textureSize(picture, 0) : textureSize(measured, 0));
  vec2 centre = (part.xy + place * part.zw) * size;
  vec2 reach = 0.5 * part.zw * size / target;
  // Each pixel of the image belongs to one pixel of the target; an enlarged one to several.
  ivec2 first = ivec2(floor(centre - reach + 0.5));
  ivec2 count = ivec2(floor(centre + reach + 0.5)) - first;
  if (count.x < 1) { first.x = int(centre.x); count.x = 1; }
  if (count.y < 1) { first.y = int(centre.y); count.y = 1; }
  ivec2 stride = (count + MOST - 1) / MOST;
  vec4 plain = vec4(0.0);
  vec4 marked = vec4(0.0);
  for (int y = 0; y < count.y; y += stride.y) {
    for (int x = 0; x < count.x; x += stride.x) {
      vec4 one = colorOf(clamp(first + ivec2(x, y), ivec2(0), ivec2(size) - 1), size);
      plain += vec4(one.rgb, 1.0) * (1.0 - one.a);
      marked += vec4(one.rgb, 1.0) * one.a;
    }
  }
  float share = sqrt(marked.a / (plain.a + marked.a));
  color = vec4(mix(plain.rgb / max(plain.a, 1.0), marked.rgb / max(marked.a, 1.0), share), 1.0);
}`;

/** The ways to colour an image. */
export const MODES = { picture: 0, depth: 1, error: 2, grey: 3, code: 4, scale: 5, difference: 6 } as const;
