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
