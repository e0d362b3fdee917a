import type { Frame, Picture } from "../net/wire";
import type { Display, PanelKind } from "../state/display";
import { depthTable, errorTable, reasonTable, TABLE_SIZE } from "./colormaps";
import type { Correspondence } from "./difference";
import type { Scales } from "./scales";
import { FRAGMENT, MODES, VERTEX } from "./shaders";

/** What the painter needs to know for one panel. */
export interface Painting {
  /** Names the OAK, whose textures are reused from frame to frame. */
  oak: string;
  kind: PanelKind;
  frame: Frame;
  display: Display;
  scales: Scales;
  /** The colours of the hatch of pixels without a value, from 0 to 1. */
  empty: readonly number[];
  /** The shown part of the image; all of it by default. */
  part?: Part | undefined;
  /** The OAK whose errors are compared with this one's, for the difference of both. */
  compared?: Compared | undefined;
}

/** Another OAK, with the colours of what only one of both measures, from 0 to 1. */
export interface Compared extends Correspondence {
  oak: string;
  frame: Frame;
  colors: readonly number[];
}

/** A part of an image: left, top, width and height as fractions. */
export type Part = readonly [number, number, number, number];

export const WHOLE: Part = [0, 0, 1, 1];

interface Slot {
  texture: WebGLTexture;
  picture: Picture | null;
  size: string;
}

type Uniforms = Record<"mode" | "measured" | "truth" | "picture" | "table" | "range" | "isRelative" | "empty" | "part" | "target" | "otherFromThis" | "tangents" | "only", WebGLUniformLocation | null>;

/** The texture units. */
const UNIT = { measured: 0, truth: 1, picture: 2, table: 3, otherMeasured: 4, otherTruth: 5 };

/**
 * Draws image panels. All share one WebGL context, because browsers allow only about 16 of them; each result is handed to the
 * canvas of its panel without a copy through main memory.
 */
export class Painter {
  private readonly canvas = new OffscreenCanvas(1, 1);
  private readonly gl: WebGL2RenderingContext;
  private uniforms: Uniforms;
  private slots = new Map<string, Slot>();
  private tables = new Map<Uint8Array, WebGLTexture>();
  private readonly reasons = reasonTable();
  private blank: WebGLTexture;

  /** `onRestored` is called when the context was lost and is back: everything must be painted again. */
  constructor(onRestored: () => void) {
    const options: WebGLContextAttributes = { antialias: false, alpha: false, depth: false, preserveDrawingBuffer: false };
    const gl = this.canvas.getContext("webgl2", options) as WebGL2RenderingContext | null;
    if (!gl) throw new Error("WebGL 2 is not available.");
    this.gl = gl;
    this.canvas.addEventListener("webglcontextlost", (event) => event.preventDefault());
    this.canvas.addEventListener("webglcontextrestored", () => {
      this.slots.clear();
      this.tables.clear();
      this.uniforms = this.link();
      this.blank = this.integerTexture();
      onRestored();
    });
    this.uniforms = this.link();
    this.blank = this.integerTexture();
  }

  /** Paints a panel at the size of its canvas; returns whether the frame has the images for it. */
  paint(target: HTMLCanvasElement, painting: Painting): boolean {
    const context = target.getContext("bitmaprenderer", { alpha: false });
    if (!context || !this.bind(painting)) return false;
    const { width, height } = target;
    if (this.canvas.width !== width) this.canvas.width = width;
    if (this.canvas.height !== height) this.canvas.height = height;
    this.gl.viewport(0, 0, width, height);
    this.gl.uniform2f(this.uniforms.target, width, height);
    this.gl.uniform4fv(this.uniforms.part, painting.part ?? WHOLE);
    this.gl.drawArrays(this.gl.TRIANGLES, 0, 3);
    context.transferFromImageBitmap(this.canvas.transferToImageBitmap());
    return true;
  }

  /** Frees the textures of all other OAKs, which were removed. */
  keep(oaks: string[]): void {
    for (const [key, slot] of this.slots) {
      if (oaks.some((oak) => key.startsWith(`${oak}/`))) continue;
      this.gl.deleteTexture(slot.texture);
      this.slots.delete(key);
    }
  }

  private bind(painting: Painting): boolean {
    const { gl, uniforms } = this;
    const { kind, frame, display, scales } = painting;
    const truth = frame.pictures.get("reference") ?? frame.pictures.get("depth");
    const picture = kind === "error" ? frame.pictures.get("sensor") : kind === "depth" ? truth : frame.pictures.get(kind);
    if (!picture || (kind === "error" && !truth)) return false;
    const { compared } = painting;
    const mode = compared ? MODES.difference : kind === "depth" || kind === "sensor" ? MODES.depth : kind === "error" ? MODES.error : kind === "reason" ? MODES.code
      : kind === "confidence" ? MODES.scale : kind === "color" ? MODES.picture : MODES.grey;
    const [from, to] = kind === "error" ? [0, scales.error] : scales.depth;
    gl.uniform1i(uniforms.mode, mode);
    gl.uniform2f(uniforms.range, from, to);
    gl.uniform1i(uniforms.isRelative, Number(display.errorUnit === "%"));
    gl.uniform3fv(uniforms.empty, painting.empty);
    this.upload(mode === MODES.picture ? UNIT.picture : UNIT.measured, painting.oak, picture);
    this.use(UNIT.truth, this.blank);
    if (truth && (mode === MODES.error || compared)) this.upload(UNIT.truth, painting.oak, truth);
    if (!this.bindCompared(compared)) return false;
    if (mode === MODES.picture) this.use(UNIT.measured, this.blank);
    const table = mode === MODES.error || compared ? errorTable() : mode === MODES.code ? this.reasons : depthTable(display.depthMap);
    this.useTable(UNIT.table, table);
    // Every sampler needs a texture of its type, used or not.
    if (mode !== MODES.picture) this.useTable(UNIT.picture, table);
    return true;
  }

  /** Binds the images of an OAK that is compared; returns whether it has them. */
  private bindCompared(compared: Compared | undefined): boolean {
    const { gl, uniforms } = this;
    this.use(UNIT.otherMeasured, this.blank);
    this.use(UNIT.otherTruth, this.blank);
    if (!compared) return true;
    const { oak, frame: { pictures } } = compared;
    const [measured, truth] = [pictures.get("sensor"), pictures.get("reference") ?? pictures.get("depth")];
    if (!measured || !truth) return false;
    this.upload(UNIT.otherMeasured, oak, measured);
    this.upload(UNIT.otherTruth, oak, truth);
    gl.uniformMatrix4fv(uniforms.otherFromThis, false, compared.otherFromThis);
    gl.uniform4fv(uniforms.tangents, compared.tangents);
    gl.uniform3fv(uniforms.only, compared.colors);
    return true;
  }

  private use(unit: number, texture: WebGLTexture): void {
    this.gl.activeTexture(this.gl.TEXTURE0 + unit);
    this.gl.bindTexture(this.gl.TEXTURE_2D, texture);
  }

  /** Binds a picture and uploads it if its texture has another one. */
  private upload(unit: number, oak: string, picture: Picture): void {
    const { gl } = this;
    const key = `${oak}/${picture.name}`;
    const size = `${picture.width}×${picture.height}`;
    let slot = this.slots.get(key);
    if (!slot) {
      slot = { texture: this.integerTexture(), picture: null, size: "" };
      this.slots.set(key, slot);
    }
    this.use(unit, slot.texture);
    if (slot.picture === picture) return;
    const [internal, format, type] = picture.format === "rgba8" ? [gl.RGBA8, gl.RGBA, gl.UNSIGNED_BYTE]
      : picture.format === "u16mm" ? [gl.R16UI, gl.RED_INTEGER, gl.UNSIGNED_SHORT] : [gl.R8UI, gl.RED_INTEGER, gl.UNSIGNED_BYTE];
    if (slot.size === size) gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, picture.width, picture.height, format, type, picture.data);
    else gl.texImage2D(gl.TEXTURE_2D, 0, internal, picture.width, picture.height, 0, format, type, picture.data);
    slot.size = size;
    slot.picture = picture;
  }

  private useTable(unit: number, bytes: Uint8Array): void {
    const { gl } = this;
    const known = this.tables.get(bytes);
    if (known) return this.use(unit, known);
    const texture = this.texture();
    this.use(unit, texture);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, TABLE_SIZE, 1, 0, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
    this.filter(gl.NEAREST);
    this.tables.set(bytes, texture);
  }

  private texture(): WebGLTexture {
    const texture = this.gl.createTexture();
    if (!texture) throw new Error("The graphics driver has no more textures.");
    return texture;
  }

  /** Returns a texture of one pixel that integer samplers accept. */
  private integerTexture(): WebGLTexture {
    const { gl } = this;
    const texture = this.texture();
    this.use(UNIT.measured, texture);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.R8UI, 1, 1, 0, gl.RED_INTEGER, gl.UNSIGNED_BYTE, new Uint8Array(1));
    this.filter(gl.NEAREST);
    return texture;
  }

  private filter(filter: number): void {
    const { gl } = this;
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, filter);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, filter);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE);
  }

  private link(): Uniforms {
    const { gl } = this;
    const program = gl.createProgram();
    for (const [type, source] of [[gl.VERTEX_SHADER, VERTEX], [gl.FRAGMENT_SHADER, FRAGMENT]] as const) {
      const shader = gl.createShader(type);
      if (!shader) continue;
      gl.shaderSource(shader, source);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS) && !gl.isContextLost()) {
      throw new Error(gl.getProgramInfoLog(program) ?? "The shaders do not link.");
    }
    gl.useProgram(program);
    gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
    const uniform = (name: string) => gl.getUniformLocation(program, name);
    for (const [name, unit] of Object.entries(UNIT)) gl.uniform1i(uniform(name), unit);
    return {
      mode: uniform("mode"), measured: uniform("measured"), truth: uniform("truth"), picture: uniform("picture"),
      table: uniform("table"), range: uniform("range"), isRelative: uniform("isRelative"), empty: uniform("empty"), part: uniform("part"), target: uniform("target"),
      otherFromThis: uniform("otherFromThis"), tangents: uniform("tangents"), only: uniform("only"),
    };
  }
}
