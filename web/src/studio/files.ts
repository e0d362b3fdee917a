import { api } from "../net/api";
import type { Units } from "../state/units";
import { changeOak, findModel, type StudioDocument, withModel, withScene } from "../state/document";
import { bytes } from "../util/format";
import type { CalibrationInfo, MotionInfo, SceneInfo, TrajectoryInfo } from "../protocol";
import { openSession } from "./session";
import type { Studio } from "./studio";

/** Opens files that were dropped onto the page or chosen: calibrations by their extension, anything else as a scene. */
export async function openFiles(studio: Studio, files: Iterable<File>): Promise<void> {
  for (const file of files) {
    const limit = studio.catalog.get().maxUploadBytes;
    if (file.size > limit) {
      studio.notify("error", `${file.name} has ${bytes(file.size)}, more than the ${bytes(limit)} that can be opened here; give it on the command line: oaktwin studio ${file.name}`);
      continue;
    }
    try {
      if (/\.oaktwin$/i.test(file.name)) await openSession(studio, file);
      else if (await isMotion(file)) useMotion(studio, await studio.motion.open(file));
      else if (await isTrajectory(file)) useTrajectory(studio, await api.openTrajectory(file));
      else if (isCalibration(file)) useCalibration(studio, await api.openCalibration(file));
      else if (isRobot(file)) useRobot(studio, await api.openRobot(file, studio.document.get().scene));
      else await readScene(studio, file);
    } catch (error) {
      studio.report("Not opened", error);
    }
  }
}

function isCalibration(file: File): boolean {
  return file.name.toLowerCase().endsWith(".json");
}

/** Postures are CSV whose first line has the names of joints; the first line of a trajectory has numbers or is a comment. */
async function isMotion(file: File): Promise<boolean> {
  if (!/\.csv$/i.test(file.name)) return false;
  const lines = (await file.slice(0, 65_536).text()).replace(/^\uFEFF/, "").split(/\r?\n/);
  const first = lines.find((line) => line.trim() !== "" && !line.startsWith("#"));
  return first !== undefined && first.split(/[,;\s]+/).every((word) => !Number.isFinite(Number.parseFloat(word)));
}

function useMotion(studio: Studio, info: MotionInfo): void {
  studio.tab.set("place");
  const rest = info.atRest.length ? ` It has no column for ${info.atRest.join(", ")}: they do not move.` : "";
  studio.notify("note", `${info.name}: ${info.postures.length.toLocaleString("en")} postures. Place → Motion measures what the OAK sees over them.${rest}`);
}

/** A trajectory is text: lines of numbers, or JSON that begins with a list, which a calibration does not. */
async function isTrajectory(file: File): Promise<boolean> {
  return /\.(txt|tum|csv)$/i.test(file.name) || (isCalibration(file) && (await file.slice(0, 256).text()).trimStart().startsWith("["));
}

function useTrajectory(studio: Studio, info: TrajectoryInfo): void {
  studio.timeline.use(info);
  const duration = (info.timesS.at(-1) ?? 0).toFixed(1);
  studio.notify("note", `${info.name}: ${info.poses.length.toLocaleString("en")} poses in ${duration} s. The timeline below the images moves the OAK along them.`);
}

function isRobot(file: File): boolean {
  return /\.(urdf|xml|mjcf)$/i.test(file.name);
}

/** Shows the scene with a dropped robot in it; the OAKs stay where they are. */
function useRobot(studio: Studio, info: SceneInfo): void {
  studio.document.commit("robot", (document): StudioDocument => ({ ...document, scene: info.id, motion: null }));
  const worst = info.findings.some(({ level }) => level !== "note") ? "warning" : "note";
  studio.notify(worst, `${info.robot?.name ?? "The robot"} is in the scene, with ${info.robot?.joints.length ?? 0} joints.`, info.findings);
}

/** A dropped mesh file whose unit nobody knows. */
export interface Asked {
  file: File;
  /** The file, read with 1 metre per unit and the up axis of its format. */
  info: SceneInfo;
}

async function readScene(studio: Studio, file: File): Promise<void> {
  const info = await api.openScene(file);
  if (info.scale === null) useScene(studio, info);
  else studio.asked.update((asked) => [...asked.filter((other) => other.info.id !== info.id), { file, info }]);
}

/** Shows a dropped mesh file as it was read, or reads it again with other units. */
export async function useDropped(studio: Studio, { file, info }: Asked, units: Units): Promise<void> {
  const isAsRead = units.scale === info.scale && units.up === info.up;
  try {
    useScene(studio, isAsRead ? info : await api.openScene(file, units));
  } catch (error) {
    studio.report("Not opened", error);
  }
}

function useScene(studio: Studio, info: SceneInfo): void {
  studio.document.commit("scene", (document): StudioDocument => ({
    ...withScene(document, info.id),
    oaks: document.oaks.map((oak) => ({ ...oak, state: { ...oak.state, pose: info.pose, frame: 0 } })),
  }));
  const worst = info.findings.some(({ level }) => level !== "note") ? "warning" : "note";
  studio.notify(worst, `${info.name}: ${info.triangles.toLocaleString("en")} triangles.`, info.findings);
}

/** Applies a calibration to the selected OAK, which becomes the model that the file names. One with errors can only be chosen. */
function useCalibration(studio: Studio, info: CalibrationInfo): void {
  studio.calibrations.set(new Map(studio.calibrations.get()).set(info.id, info));
  if (info.findings.some(({ level }) => level === "error")) {
    studio.notify("error", `${info.name} has errors and is not used.`, info.findings);
    return;
  }
  const model = info.model === null ? undefined : findModel(studio.catalog.get(), info.model);
  studio.document.commit("calibration", (document) =>
    changeOak(document, document.selected, (state) => {
      const next = model && model.name !== state.model ? withModel(state, model) : state;
      return { ...next, calibration: info.id, populationSeed: null };
    }),
  );
  studio.notify("note", `${info.name} calibrates the selected OAK${model ? `, an ${model.name}` : ""}.`, info.findings);
}
