/** One triangle that covers the target; `place` runs from the top left. */
export const VERTEX = `#version 300 es
out vec2 place;
void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0;
  place = vec2(corner.x, 1.0 - corner.y);
  gl_Position = vec4(corner * 2.0 - 1.0, 0.0, 1.0);
}`;

/** Colours one image. `mode` is {@link MODES}; millimetres become metres, 0 is no value. */
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

vec3 lookUp(float from0to1) {
  return texture(table, vec2((clamp(from0to1, 0.0, 1.0) * 255.0 + 0.5) / 256.0, 0.5)).rgb;
}

// Pixels without a value get a hatch, which no colour map has.
vec3 hatch() {
  return empty[int(mod(gl_FragCoord.x + gl_FragCoord.y, 8.0) < 2.0)];
}

uint at(usampler2D image) {
  ivec2 size = textureSize(image, 0);
  return texelFetch(image, min(ivec2(place * vec2(size)), size - 1), 0).r;
}

void main() {
  color.a = 1.0;
  if (mode == 0) {
    color.rgb = texture(picture, place).rgb;
    return;
  }
  uint value = at(measured);
  if (mode == 1) {
    float metres = float(value) * 0.001;
    color.rgb = value == 0u ? hatch() : lookUp((metres - range.x) / max(range.y - range.x, 1e-6));
  } else if (mode == 2) {
    uint exact = at(truth);
    float error = (float(value) - float(exact)) * 0.001;
    if (isRelative) error *= 100.0 / max(float(exact) * 0.001, 1e-3);
    color.rgb = value == 0u || exact == 0u ? hatch() : lookUp(0.5 + 0.5 * error / max(range.y, 1e-9));
  } else if (mode == 3) {
    color.rgb = vec3(float(value) / 255.0);
  } else if (mode == 4) {
    color.rgb = texelFetch(table, ivec2(int(value), 0), 0).rgb;
  } else {
    color.rgb = lookUp(float(value) / 255.0);
  }
}`;

/** The ways to colour an image. */
export const MODES = { picture: 0, depth: 1, error: 2, grey: 3, code: 4, scale: 5 } as const;
