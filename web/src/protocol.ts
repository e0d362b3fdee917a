import type { RobotInfo } from "./protocol-robot";
import type { Animation } from "./protocol-session";

/**
 * The interface between the page and the server of `oaktwin studio`.
 *
 * Lengths are metres and angles degrees unless a name says otherwise. The world is that of the scene's file; a device's body frame
 * is ROS's (x forward, y left, z up). Pixels count from the top left. The Rust side is in `crates/studio/src/protocol`.
 *
 * HTTP, all below the page's own origin:
 *
 * | request | answer |
 * |---|---|
 * | `GET /api/catalog` | {@link Catalog} |
 * | `GET /api/scenes/{id}` | {@link SceneInfo} |
 * | `GET /api/scenes/{scene}/mesh?triangles=N` | a mesh, see {@link MeshHeader} |
 * | `GET /api/scenes/{scene}/textures` | textured surfaces, see {@link TexturedHeader} |
 * | `POST /api/scenes?name=room.glb`, the file as the body; of a mesh file also `scale=0.001`, metres per unit, and `up=z` | {@link SceneInfo}; 422 with {@link Failure} |
 * | `POST /api/robots?name=arm.urdf&scene=ID`, a URDF or MJCF file as the body | {@link SceneInfo} of the scene with the robot; 422 with {@link Failure} |
 * | `POST /api/calibrations?name=unit.json`, the file as the body | {@link CalibrationInfo}; 422 with {@link Failure} |
 * | `POST /api/trajectories?name=path.txt`, the file as the body | {@link TrajectoryInfo}; 422 with {@link Failure} |
 * | `GET /api/trajectories/{id}` | {@link TrajectoryInfo} |
 * | `POST /api/session/save`, {@link SaveRequest} | a file |
 * | `POST /api/session/open?name=room.oaktwin`, the file as the body | {@link SessionInfo}; 422 with {@link Failure} |
 * | `GET /api/models/{name}/body` | a mesh in the body frame |
 * | `POST /api/export`, {@link ExportRequest} | a file (`Content-Disposition` has its name, `X-Findings` the {@link Finding}s); 422 with {@link Failure} |
 * | `POST /api/accuracy`, {@link OakState} | {@link AccuracyCurve}; 422 with {@link Failure} |
 * | `POST /api/coverage`, {@link CoverageRequest} | {@link CoverageAnswer}; 422 with {@link Failure} |
 * | `POST /api/coverage/surface`, {@link SurfaceRequest} | a mesh of the region's surface, see {@link SurfaceRequest}; 422 with {@link Failure} |
 * | `GET /api/live`, a WebSocket | {@link ClientMessage} as text; {@link ServerMessage} as text, frames as binary |
 *
 * Any other status than 200 has a {@link Failure} as its body.
 *
 * A `scene` in a request is the id of a scene, or of an animated one at a time code: "ID@12.5".
 */

export type * from "./protocol-mesh";
export type * from "./protocol-robot";
export type * from "./protocol-session";

/** A 3D vector. */
export type Vec3 = [number, number, number];

/** What the server knows before any scene. */
export interface Catalog {
  version: string;
  /** The scene that is shown first. */
  scene: string;
  /** The model that is shown first. */
  model: string;
  models: Model[];
  engines: Engine[];
  /** The filters that can be chosen, with the parameters of each. */
  filters: Filter[];
  /** The ways in which a stereo pair can have changed since its calibration; each is 0 by default. */
  drift: Parameter[];
  /** The formats of robots and simulators, each with one line about it. */
  robotFormats: { name: string; help: string }[];
  /** The reasons why a pixel has no value, sorted by code; codes have gaps. Code 0 is a measured pixel. */
  reasons: Reason[];
  /** What can become of a point of a surface, sorted by code: code 0 is a measured one; the reasons, and others such as "hidden". */
  outcomes: Reason[];
  /** The largest file that can be dropped, bytes. */
  maxUploadBytes: number;
}

export interface Model {
  /** The name, which is its id: "OAK4-D". */
  name: string;
  maker: string;
  /** "RVC2", "RVC4". */
  generation: string;
  /** The sizes along x, y and z, and the centre, in the body frame. */
  body: { size: Vec3; centre: Vec3 };
  cameras: Camera[];
  /** Whether it has a dot projector. */
  hasProjector: boolean;
  /** Whether its left and right cameras have a fisheye description besides the pinhole one. */
  hasFisheye: boolean;
  /** Empty for a model without depth. */
  depthSensors: DepthSensor[];
}

/** A camera of a device at its used resolution. */
export interface Camera {
  /** "rgb", "left", "right", "tof". */
  role: string;
  resolution: [number, number];
  hfovDeg: number;
  vfovDeg: number;
  /** Row-major 3 × 4: from the optical frame (x right, y down, z forward) to the body frame. */
  bodyFromCamera: number[];
}

export interface DepthSensor {
  /** "depth_stereo" or "depth_tof"; the prim if the device has several of the kind. */
  id: string;
  kind: "stereo" | "tof";
  resolution: [number, number];
  hfovDeg: number;
  vfovDeg: number;
  bodyFromCamera: number[];
  /** The distances of the range shells; null where the maker publishes none. */
  minimumM: number | null;
  idealM: [number, number] | null;
  maximumM: number | null;
  baselineM: number | null;
  /** The names of the engines that model it, the default first. */
  engines: string[];
  /** The names of DepthAI's presets for it. */
  presets: string[];
  /** The accuracy bands that the maker publishes: errors of at most `percent` up to `toM`. */
  bands: { fromM: number; toM: number; percent: number }[];
}

export interface Engine {
  /** "stereo-noise". */
  name: string;
  help: string;
  /** Whether it needs the images of both cameras, which take longer to render. */
  isMatcher: boolean;
  parameters: Parameter[];
}

export interface Parameter {
  name: string;
  /** The heading to show it under. */
  group: string;
  type: "number" | "integer" | "boolean" | "string";
  unit: string | null;
  minimum: number | null;
  maximum: number | null;
  /** The range that devices or experiments usually have, for a slider; null if it is the whole range. */
  typical: [number, number] | null;
  /** The step from the minimum to the next valid number; null if every number is valid. */
  step: number | null;
  /** The values of a `string` parameter, if they are enumerated. */
  choices: string[] | null;
  /** The default as text. The effective default of a model may differ: {@link FrameHeader.parameters}. */
  default: string;
  documentation: string;
  /** Where the default comes from: "DepthAI", "estimate", "camera", … */
  source: string;
  isEstimate: boolean;
}

export interface Filter {
  name: string;
  parameters: Parameter[];
}

export interface Reason {
  code: number;
  /** "too_near". */
  name: string;
  documentation: string;
}

/** What can be wrong. */
export interface Failure {
  /** `FILE: PLACE: what is wrong; what to do`. */
  error: string;
  findings?: Finding[];
}

export interface Finding {
  level: "note" | "warning" | "error";
  place: string;
  message: string;
  remedy: string;
}

export interface SceneInfo {
  id: string;
  /** The name of the file, or "demo room". */
  name: string;
  up: "y" | "z";
  /** Metres per unit of a mesh file that does not say; null for a USD stage and a Collada file. */
  scale: number | null;
  triangles: number;
  /** The corners of the bounding box. */
  bounds: [Vec3, Vec3];
  objects: SceneObject[];
  findings: Finding[];
  /** A pose of the body that shows the scene. */
  pose: Pose;
  /** Null if nothing in it moves. */
  animation: Animation | null;
  /** The robot in the scene. The id of the scene in another posture is `ID~P1,P2,…`, with the position of each of the joints. */
  robot: RobotInfo | null;
}

export interface SceneObject {
  /** The path of the prim. */
  path: string;
  bounds: [Vec3, Vec3];
}

export interface CalibrationInfo {
  id: string;
  name: string;
  /** The model that the device says it is; null if it does not match a known one. */
  model: string | null;
  findings: Finding[];
}

/** A pose of the body in the world. */
export interface Pose {
  position: Vec3;
  /** x, y, z, w. */
  quaternion: [number, number, number, number];
}

/** Everything that determines the outputs of one OAK. It is what a link to the page stores. */
export interface OakState {
  model: string;
  /** The id of a dropped calibration. */
  calibration: string | null;
  pose: Pose;
  /** {@link DepthSensor.id}. */
  sensor: string;
  /** The optics of the wide models' left and right cameras. */
  lens: "pinhole" | "fisheye";
  engine: string;
  preset: string | null;
  /** Filters as text, "NAME" or "NAME:KEY=VALUE,…", in order; they replace the preset's. Null: the preset's. */
  filters: string[] | null;
  /** Only those that were changed, as text. */
  parameters: Record<string, string>;
  extendedDisparity: boolean;
  seed: number;
  /** The seed of an individual unit's calibration error; null for a unit without one. */
  deviceSeed: number | null;
  /** The seed of a unit of the model's population, whose cameras differ from the nominal ones; null for the nominal device. */
  populationSeed: number | null;
  /** The drift of the stereo pair since its calibration: only what is not 0, as text, by the names in {@link Catalog.drift}. */
  drift: Record<string, string>;
  /** The brightness of the dot projector and of the scene's own light, for stereo engines. Night is an ambient of 0. */
  projector: number;
  ambient: number;
  /** The number of the frame of a trajectory or an animation: frames differ in their noise. 0 for a frame on its own. */
  frame: number;
}

/** An image of an OAK. */
export type ImageName =
  | "color" // rgba8
  | "depth" // u16mm: ground truth in the camera of the sensor
  | "reference" // u16mm: ground truth at the pixels of `sensor`: only sent where it differs from `depth`; errors refer to it
  | "sensor" // u16mm: the measured depth
  | "confidence" // u8; not made by every engine
  | "left" // u8: the infrared image of the left camera, rectified
  | "right"
  | "reason"; // u8: codes of Catalog.reasons

export interface FrameRequest {
  type: "frame";
  /** Increasing; the answer repeats it. A newer request of the same `oak` replaces older ones, which are not answered. */
  id: number;
  /** A key that the page chooses for each OAK. */
  oak: string;
  scene: string;
  state: OakState;
  /** The size of the images; null for the sensor's own. */
  size: [number, number] | null;
  images: ImageName[];
  /** The rectangle for {@link FrameHeader.statistics}, as fractions of the image: left, top, right, bottom. */
  region: [number, number, number, number];
  /** Every so many pixels of a row and of a column have a colour of their own, 1 to 8; those between are interpolated. 1 if missing. Colour takes most of the time of a new view. */
  colorStep?: number;
  /** Whether images for rest follow. A preview comes first, and interrupts images for rest that are being computed. */
  isPreview?: boolean;
}

/** Asks about a pixel of the last frame of an OAK. */
export interface ProbeRequest {
  type: "probe";
  id: number;
  oak: string;
  /** Fractions of the sensor's image: 0 is the left or top edge. */
  x: number;
  y: number;
}

export type ClientMessage = FrameRequest | ProbeRequest;

/**
 * A binary message: 4 bytes, the length N of the JSON in little endian; N bytes of JSON, which is this header; then the images.
 */
export interface FrameHeader {
  id: number;
  oak: string;
  images: ImageHeader[];
  /** The effective parameters of the engine, as text. */
  parameters: Record<string, string>;
  /** Those filters that ran, as text. */
  filters: string[];
  findings: Finding[];
  statistics: Statistics;
  /** What the frame took on the server, ms. */
  milliseconds: number;
  /** The horizontal field of view of the images. */
  hfovDeg: number;
  vfovDeg: number;
}

export interface ImageHeader {
  name: ImageName;
  width: number;
  height: number;
  /** `u16mm`: millimetres, 0 for none, 65535 for 65.535 m and beyond. */
  format: "rgba8" | "u16mm" | "u8";
  /** The place in the payload after the header. The bytes are an LZ4 block of the little-endian pixels, row by row. */
  offset: number;
  length: number;
  /**
   * Whether the pixels are those of the last frame with this image that the server sent for this OAK. Such an image has a `length` of
   * 0, because the page still has it.
   */
  unchanged?: boolean;
}

export interface Statistics {
  /** The number of pixels in the region that show a surface. */
  pixels: number;
  /** The fraction of them with a value. */
  fillRate: number;
  /** Of the measured ones; null if there are none. Errors are measured minus true. */
  medianErrorM: number | null;
  medianAbsoluteErrorM: number | null;
  medianAbsoluteErrorPercent: number | null;
  p95AbsoluteErrorM: number | null;
  /** The number of pixels of each reason, by its code. */
  reasons: number[];
  /** Errors in bins of equal width between the ends. */
  histogram: { fromM: number; toM: number; counts: number[] };
}

export interface ProbeAnswer {
  type: "probe";
  id: number;
  oak: string;
  /** The pixel of the sensor's image. */
  pixel: [number, number];
  trueM: number | null;
  /** In pixels of the matcher; null without a stereo pair. */
  disparityPx: number | null;
  measuredM: number | null;
  errorM: number | null;
  /** The distance to the next depth that the sensor can report; null without disparity. */
  stepM: number | null;
  /** The code in {@link Catalog.reasons}. */
  reason: number;
  /** The prim in the pixel. */
  object: string | null;
  /** The prim that hides it from the other camera, for a reason of occlusion. */
  occluder: string | null;
  /** The point on the surface, in the world. */
  point: Vec3 | null;
}

/** A request that cannot be answered. */
export interface Rejection extends Failure {
  type: "error";
  id: number;
  oak: string;
  /** The parameter or field that is at fault, if one is. */
  field: string | null;
}

/** Binary messages are frames. */
export type ServerMessage = ProbeAnswer | Rejection;

/** The accuracy by the vendor's method: the error of the median over distances. */
export interface AccuracyCurve {
  distancesM: number[];
  /** The median error of the median unit, percent; null where nothing was measured. */
  errorPercent: (number | null)[];
  /** The fraction of the pixels with a value. */
  fillRate: number[];
  bands: { fromM: number; toM: number; percent: number }[];
}

export interface ExportRequest {
  what: "asset" | "robot" | "image" | "error" | "statistics" | "parameters" | "command" | "python";
  scene: string;
  state: OakState;
  size: [number, number] | null;
  /** For `image`. */
  image?: ImageName;
  /** `usda` or `usdz` for an asset; a name of {@link Catalog.robotFormats} for `robot`, a zip archive; `npy` or `png` for an image; `json` or `csv` for statistics. */
  format?: string;
  /** For `statistics`: the rectangle as fractions of the image, and the other OAKs. */
  region?: [number, number, number, number];
  others?: { state: OakState; size: [number, number] | null }[];
  /** For commands: the trajectory to which the state's frame belongs; and of an animated scene, the first time code and the step. */
  trajectory?: string;
  codes?: [number, number];
}

export interface CoverageRequest {
  scene: string;
  states: OakState[];
  /** A box in the world, or the path of an object. */
  region: { minimum: Vec3; maximum: Vec3 } | { object: string };
  /** The largest error of a point that counts as measured; null for any. */
  toleranceMm?: number | null;
}

/**
 * Asks for the surface of a region in small triangles. In the mesh, the object of a triangle is the code of its outcome in
 * {@link Catalog.outcomes}; the colours mean nothing.
 */
export interface SurfaceRequest {
  scene: string;
  state: OakState;
  region: CoverageRequest["region"];
}

/** What is measured of a region's surface. */
export interface PoseCoverage {
  /** The share of the surface that the camera sees, measured or not. */
  seen: number;
  /** The share that is measured. */
  measured: number;
  medianAbsoluteErrorM: number | null;
  /** The shares that are not measured, by the name of the reason. */
  lost: Record<string, number>;
  /** The share of the pixels that show the robot of the scene; null without a robot, and for all OAKs together. */
  ownRobot: number | null;
}

/** For each of the states, and for all of them together. */
export interface CoverageAnswer {
  poses: PoseCoverage[];
  together: PoseCoverage;
}
