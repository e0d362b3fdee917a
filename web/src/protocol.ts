// Made from the types of `crates/studio` by its tests; see `crates/studio/src/typescript.rs`.

/**
 * The interface between the page and the server of `oaktwin studio`.
 *
 * Lengths are metres and angles degrees unless a name says otherwise. The world is that of the scene's file; a device's body frame
 * is ROS's (x forward, y left, z up). Pixels count from the top left.
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
 * | `POST /api/motions?name=poses.csv&scene=ID`, postures of the scene's robot as the body | {@link MotionInfo}; 422 with {@link Failure} |
 * | `GET /api/motions/{id}` | {@link MotionInfo} |
 * | `POST /api/motions/coverage`, {@link MotionRequest} | lines of JSON, each a {@link MotionLine}, as they come; 422 with {@link Failure} |
 * | `POST /api/motions/command`, {@link MotionRequest} | a file with the command that measures the same; 422 with {@link Failure} |
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
 * A `scene` in a request is the id of a scene, or of an animated one at a time code: "ID@12.5". See also {@link SceneInfo}.
 */

/** A 3D vector. */
export type Vec3 = [number, number, number];

/** What is outside a texture. */
export type TextureWrap = "repeat" | "mirror" | "clamp";

/** A problem in an input: where it is, what is wrong, and how to fix it. */
export interface Finding {
  /** A short stable name, such as "baseline-off". */
  code: string;
  level: "note" | "warning" | "error";
  place: string;
  message: string;
  remedy: string;
}

/** Messages of the page on the WebSocket. */
export type ClientMessage = FrameRequest | ProbeRequest;

/** The accuracy by the vendor's method: the error of the median over distances. */
export type AccuracyCurve = {
  distancesM: Array<number>;
  /** The median error of the median unit, percent; null where nothing was measured. */
  errorPercent: Array<number | null>;
  /** The fraction of the pixels with a value. */
  fillRate: Array<number>;
  bands: Array<Band>;
};

/** The time codes of an animated scene. */
export type Animation = {
  first: number;
  last: number;
  codesPerSecond: number;
  /** The time codes from frame to frame. */
  step: number;
};

/** An accuracy that the maker publishes: an error of at most `percent`. */
export type Band = {
  fromM: number;
  toM: number;
  percent: number;
};

export type Body = {
  /** Along x, y and z, metres. */
  size: Vec3;
  centre: Vec3;
};

/** A calibration that was dropped onto the page. */
export type CalibrationInfo = {
  id: string;
  name: string;
  /** The model that the device says it is; null if it does not match a known one. */
  model: string | null;
  findings: Finding[];
};

/** A camera of a device at its used resolution. */
export type Camera = {
  /** "rgb", "left", "right", "tof". */
  role: string;
  resolution: [number, number];
  hfovDeg: number;
  vfovDeg: number;
  /** Row-major 3 × 4: from the optical frame (x right, y down, z forward) to the body frame. */
  bodyFromCamera: Array<number>;
};

/** What the server knows before any scene. */
export type Catalog = {
  version: string;
  /** The scene that is shown first. */
  scene: string;
  /** The model that is shown first. */
  model: string;
  models: Array<Model>;
  engines: Array<Engine>;
  /** The filters that can be chosen, with the parameters of each. */
  filters: Array<Filter>;
  /** The ways in which a stereo pair can have changed since its calibration; each is 0 by default. */
  drift: Array<Parameter>;
  /** The formats of robots and simulators, each with one line about it. */
  robotFormats: Array<RobotFormat>;
  /** The reasons why a pixel has no value, sorted by code; codes have gaps. Code 0 is a measured pixel. */
  reasons: Array<Reason>;
  /** What can become of a point of a surface, sorted by code: code 0 is a measured one; the reasons, and others such as "hidden". */
  outcomes: Array<Reason>;
  /** The largest file that can be dropped, bytes. */
  maxUploadBytes: number;
};

/** For each of the states, and for all of them together. */
export type CoverageAnswer = {
  poses: Array<PoseCoverage>;
  together: PoseCoverage;
};

/** A box in the world, or the path of an object. */
export type CoverageRegion = { minimum: [number, number, number], maximum: [number, number, number], } | { object: string, };

export type CoverageRequest = {
  scene: string;
  states: Array<OakState>;
  /** A box in the world, or an object. */
  region: CoverageRegion;
  /** The largest error of a point that counts as measured; null for any. */
  toleranceMm?: number | null;
};

export type DepthSensor = {
  /** `depth_stereo` or `depth_tof`; the prim if the device has several of the kind. */
  id: string;
  kind: "stereo" | "tof";
  /** The distances of the range shells; null where the maker publishes none. */
  minimumM: number | null;
  idealM: [number, number] | null;
  maximumM: number | null;
  baselineM: number | null;
  /** The names of the engines that model it, the default first. */
  engines: Array<string>;
  /** The names of DepthAI's presets for it. */
  presets: Array<string>;
  /** The accuracy bands that the maker publishes. */
  bands: Array<Band>;
  resolution: [number, number];
  hfovDeg: number;
  vfovDeg: number;
  /** Row-major 3 × 4: from the optical frame (x right, y down, z forward) to the body frame. */
  bodyFromCamera: Array<number>;
};

export type Engine = {
  /** "stereo-noise". */
  name: string;
  help: string;
  /** Whether it needs the images of both cameras, which take longer to render. */
  isMatcher: boolean;
  parameters: Array<Parameter>;
};

/** What can be taken away. */
export type Export = "asset" | "robot" | "image" | "error" | "statistics" | "parameters" | "command" | "python";

/** Asks for a file. */
export type ExportRequest = {
  what: Export;
  scene: string;
  state: OakState;
  size: [number, number] | null;
  /** For `image`. */
  image?: ImageName;
  /**
   * `usda` or `usdz` for an asset; a name of `Catalog.robotFormats` for `robot`, a zip archive; `npy` or `png` for an image; `json` or
   * `csv` for statistics.
   */
  format?: string;
  /** For `statistics`: the rectangle as fractions of the image. */
  region?: [number, number, number, number];
  /** For `statistics`: the other OAKs. */
  others?: Array<SizedState>;
  /** For commands: the trajectory to which the state's frame belongs. */
  trajectory?: string;
  /** For commands of an animated scene: the first time code of its frames, and the time codes from frame to frame. */
  codes?: [number, number];
};

/** What is wrong with a request. */
export type Failure = {
  /** `FILE: PLACE: what is wrong; what to do`. */
  error: string;
  /** The parameter or field at fault, if one is. */
  field: string | null;
  findings?: Finding[];
};

export type Filter = {
  name: string;
  parameters: Array<Parameter>;
};

/** A binary message: 4 bytes, the length N of the JSON in little endian; N bytes of JSON, which is this header; then the images. */
export type FrameHeader = {
  id: number;
  oak: string;
  images: Array<ImageHeader>;
  /** The effective parameters of the engine, as text. */
  parameters: Record<string, string>;
  /** Those filters that ran, as text. */
  filters: Array<string>;
  findings: Finding[];
  statistics: Statistics;
  /** What the frame took on the server, ms. */
  milliseconds: number;
  /** The horizontal field of view of the images. */
  hfovDeg: number;
  vfovDeg: number;
};

/** Asks for the images of an OAK. */
export type FrameRequest = {
  type: "frame";
  /** Increasing; the answer repeats it. A newer request of the same `oak` replaces older ones, which are not answered. */
  id: number;
  /** A key that the page chooses for each OAK. */
  oak: string;
  scene: string;
  state: OakState;
  /** The size of the images; null for the sensor's own. */
  size: [number, number] | null;
  images: Array<ImageName>;
  /** The rectangle for the statistics, as fractions of the image: left, top, right, bottom. */
  region: [number, number, number, number];
  /**
   * Every so many pixels of a row and of a column have a colour of their own, 1 to 8; those between are interpolated. 1 if missing.
   * Colour takes most of the time of a new view.
   */
  colorStep?: number;
  /** Whether images for rest follow. A preview comes first, and interrupts images for rest that are being computed. */
  isPreview?: boolean;
};

/** Errors in bins of equal width between the ends. */
export type Histogram = {
  fromM: number;
  toM: number;
  counts: Array<number>;
};

export type ImageHeader = {
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
  unchanged: boolean;
};

/** An image of an OAK. */
export type ImageName = "color" | "depth" | "reference" | "sensor" | "confidence" | "left" | "right" | "reason";

/**
 * A binary mesh: 4 bytes, the length N of the JSON in little endian; N bytes of JSON, which is this header; padding with zeros to a
 * multiple of 4; then float32 positions (3 per vertex), uint8 sRGB colours with alpha (4 per vertex), uint32 indices (3 per
 * triangle), and for each triangle the uint32 index of its object in `SceneInfo.objects`. All little endian.
 */
export type MeshHeader = {
  vertices: number;
  triangles: number;
  /** The number of triangles of the full scene. */
  ofTriangles: number;
};

export type Model = {
  /** The name, which is its id: "OAK4-D". */
  name: string;
  maker: string;
  /** "RVC2", "RVC4". */
  generation: string;
  /** In the body frame. */
  body: Body;
  cameras: Array<Camera>;
  /** Whether it has a dot projector. */
  hasProjector: boolean;
  /** Whether its left and right cameras have a fisheye description besides the pinhole one. */
  hasFisheye: boolean;
  /** Empty for a model without depth. */
  depthSensors: Array<DepthSensor>;
};

export type MotionAnswer = {
  postures: Array<PostureCoverage>;
  /** By all postures together: a point is measured if it is in one of them. */
  together: PoseCoverage;
  /** `coverage.csv` as the command writes it. */
  csv: string;
};

/** A list of postures of the robot in a scene. */
export type MotionInfo = {
  id: string;
  name: string;
  /** The positions of `RobotInfo.joints` in each posture. */
  postures: Array<Array<number>>;
  /** The joints that have no column in the file, so that they do not move. */
  atRest: Array<string>;
};

/** A line of the answer to a [`MotionRequest`]: how many postures are done, and at last the result or an error. */
export type MotionLine = { "type": "progress", done: number, total: number, } | { "type": "answer" } & MotionAnswer | { "type": "error" } & Failure;

/** Asks for the coverage of a region over a list of postures, by an OAK on a link or, without one, in the world. */
export type MotionRequest = {
  /** The scene, with the robot in the posture to which the pose of the state belongs. */
  scene: string;
  motion: string;
  mount: string | null;
  state: OakState;
  region: CoverageRegion;
  /** The largest error of a point that counts as measured; null for any. */
  toleranceMm: number | null;
};

/** Everything that determines the outputs of one OAK. It is what a link to the page stores. */
export type OakState = {
  model: string;
  /** The id of a dropped calibration. */
  calibration: string | null;
  pose: Pose;
  /** `DepthSensor.id`. */
  sensor: string;
  /** The optics of the wide models' left and right cameras. */
  lens: "pinhole" | "fisheye";
  engine: string;
  preset: string | null;
  /** Filters as text, "NAME" or "NAME:KEY=VALUE,…", in order; they replace the preset's. Null: the preset's. */
  filters: Array<string> | null;
  /** Only those that were changed, as text. */
  parameters: Record<string, string>;
  extendedDisparity: boolean;
  seed: number;
  /** The seed of an individual unit's calibration error; null for a unit without one. */
  deviceSeed: number | null;
  /** The seed of a unit of the model's population, whose cameras differ from the nominal ones; null for the nominal device. */
  populationSeed: number | null;
  /** The drift of the stereo pair since its calibration: only what is not 0, as text, by the names in `Catalog.drift`. */
  drift: Record<string, string>;
  /** The brightness of the dot projector and of the scene's own light, for stereo engines. Night is an ambient of 0. */
  projector: number;
  ambient: number;
  /** The ground truth of transparent surfaces: themselves, or what lies behind the clear ones. */
  transparent: "surface" | "through";
  /** The image sensor of colours: only its changed parameters, as text; null if colours are exact. */
  colorImager: Record<string, string> | null;
  /** The number of the frame of a trajectory or an animation: frames differ in their noise. 0 for a frame on its own. */
  frame: number;
};

export type Parameter = {
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
  choices: Array<string> | null;
  /** The default as text. The effective default of a model may differ: `FrameHeader.parameters`. */
  default: string;
  documentation: string;
  /** Where the default comes from: "DepthAI", "estimate", "camera", … */
  source: string;
  isEstimate: boolean;
};

/** A pose of the body in the world. */
export type Pose = {
  position: Vec3;
  /** x, y, z, w. */
  quaternion: [number, number, number, number];
};

/** What is measured of a region's surface. */
export type PoseCoverage = {
  /** The share of the surface that the camera sees, measured or not. */
  seen: number;
  /** The share that is measured. */
  measured: number;
  medianAbsoluteErrorM: number | null;
  /** The shares that are not measured, by the name of the reason. */
  lost: Record<string, number>;
  /** The share of the pixels that show the robot of the scene; null without a robot, and for all OAKs together. */
  ownRobot: number | null;
};

/** The coverage in a posture. */
export type PostureCoverage = {
  /** The share of the surface that the robot hides. */
  hiddenByRobot: number;
  /** The links in the image, with the share of the pixels that show each, the largest first. */
  links: Array<[string, number]>;
  /** The share of the surface that the camera sees, measured or not. */
  seen: number;
  /** The share that is measured. */
  measured: number;
  medianAbsoluteErrorM: number | null;
  /** The shares that are not measured, by the name of the reason. */
  lost: Record<string, number>;
  /** The share of the pixels that show the robot of the scene; null without a robot, and for all OAKs together. */
  ownRobot: number | null;
};

/** What a pixel shows. */
export type ProbeAnswer = {
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
  /** The code in `Catalog.reasons`. */
  reason: number;
  /** The prim in the pixel. */
  object: string | null;
  /** The prim that hides it from the other camera, for a reason of occlusion. */
  occluder: string | null;
  /** The point on the surface, in the world. */
  point: Vec3 | null;
};

/** Asks about a pixel of the last frame of an OAK. */
export type ProbeRequest = {
  type: "probe";
  id: number;
  oak: string;
  /** Fractions of the sensor's image: 0 is the left or top edge. */
  x: number;
  y: number;
};

export type Reason = {
  code: number;
  /** Such as `too_near`. */
  name: string;
  documentation: string;
};

/** A request that cannot be answered. */
export type Rejection = {
  id: number;
  oak: string;
  /** `FILE: PLACE: what is wrong; what to do`. */
  error: string;
  /** The parameter or field at fault, if one is. */
  field: string | null;
  findings?: Finding[];
};

export type RobotFormat = {
  name: string;
  help: string;
};

/** A robot, in the posture of its scene. */
export type RobotInfo = {
  name: string;
  /** The joints that can be moved. */
  joints: Array<RobotJoint>;
  links: Array<RobotLink>;
};

export type RobotJoint = {
  name: string;
  /** Whether its positions are angles in radians; otherwise lengths in metres. */
  isRevolute: boolean;
  /** Null for a joint without limits. */
  limits: [number, number] | null;
  position: number;
};

export type RobotLink = {
  name: string;
  /** The path below which its objects are. */
  path: string;
  /** The pose of its frame in the world. */
  pose: Pose;
};

/** What a session has: the state of the page, which only the page understands, and the ids of what was dropped. */
export type SaveRequest = {
  document: unknown;
  display: unknown;
  scene: string;
  calibrations: Array<string>;
  trajectory: string | null;
  /** The list of postures of the scene's robot. */
  motion: string | null;
};

export type SceneInfo = {
  id: string;
  /** The name of the file, or "demo room". */
  name: string;
  up: "y" | "z";
  /** Metres per unit of a mesh file that states no unit; null for others. */
  scale: number | null;
  triangles: number;
  /** The corners of the bounding box. */
  bounds: [Vec3, Vec3];
  objects: Array<SceneObject>;
  findings: Finding[];
  /** A pose of the body that shows the scene. */
  pose: Pose;
  /** Null if nothing in it moves. */
  animation: Animation | null;
  /**
   * The materials and labels whose reflectance in the infrared can be set: the id of the scene with one is `ID;NAME=REFLECTANCE`, with
   * a percent-encoded name, and may have more of them.
   */
  infrared: Array<string>;
  /** The robot in the scene. The id of the scene in another posture is `ID~P1,P2,…`, with the position of each of the joints. */
  robot: RobotInfo | null;
};

export type SceneObject = {
  /** The path of the prim. */
  path: string;
  bounds: [Vec3, Vec3];
};

/** A message as text; frames are binary. */
export type ServerMessage = { "type": "probe" } & ProbeAnswer | { "type": "error" } & Rejection;

/** What a page shows after a session was opened. */
export type SessionInfo = {
  document: unknown;
  display: unknown;
  scene: SceneInfo;
  calibrations: Array<CalibrationInfo>;
  trajectory: TrajectoryInfo | null;
  motion: MotionInfo | null;
};

/** An OAK with the size of its images. */
export type SizedState = {
  state: OakState;
  size: [number, number] | null;
};

export type Statistics = {
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
  reasons: Array<number>;
  histogram: Histogram;
};

/**
 * Asks for the surface of a region in small triangles. In the mesh, the object of a triangle is the code of its outcome in
 * `Catalog.outcomes`; the colours mean nothing.
 */
export type SurfaceRequest = {
  scene: string;
  state: OakState;
  region: CoverageRegion;
};

export type TextureHeader = {
  width: number;
  height: number;
  wrap: [TextureWrap, TextureWrap];
};

/** Triangles with one material. */
export type TexturedGroup = {
  vertices: number;
  texture: number;
  /** The linear factor of the texture. */
  color: Vec3;
};

/**
 * Binary surfaces with textures, over those of the mesh; none if there are too many. Laid out like a mesh: after the header and its
 * padding, for each group the float32 positions (3 per vertex) and coordinates (2 per vertex) of its triangles' corners; then the rgba8
 * pixels of the textures, the lowest row first.
 */
export type TexturedHeader = {
  groups: Array<TexturedGroup>;
  textures: Array<TextureHeader>;
};

/** A trajectory that was dropped onto the page. */
export type TrajectoryInfo = {
  id: string;
  name: string;
  poses: Array<Pose>;
  /** The time of each pose, s, from 0. */
  timesS: Array<number>;
};
