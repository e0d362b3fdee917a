import { api } from "../net/api";
import { linkedFrom } from "../state/link";
import { save } from "../util/away";
import type { Studio } from "./studio";

/** Saves what the page shows, with the files that were dropped onto it, as one file. */
export async function saveSession(studio: Studio): Promise<void> {
  studio.timeline.pause();
  const [document, display] = [studio.document.get(), studio.display.get()];
  const calibrations = [...new Set(document.oaks.flatMap(({ state }) => state.calibration ?? []))];
  try {
    const { name, file } = await api.saveSession({ document, display, scene: document.scene, calibrations, trajectory: document.trajectory, motion: document.motion });
    save(name, file);
  } catch (error) {
    studio.report("The session is not saved", error);
  }
}

/** Opens such a file; one that cannot be opened changes nothing. */
export async function openSession(studio: Studio, file: File): Promise<void> {
  const session = await api.openSession(file);
  const linked = linkedFrom(session, studio.display.get());
  if (!linked || linked.document.scene !== session.scene.id) throw new Error(`${file.name}: has no state that this page can show; open a file that Studio saved.`);
  studio.timeline.pause();
  const calibrations = session.calibrations.map((info) => [info.id, info] as const);
  studio.calibrations.set(new Map([...studio.calibrations.get(), ...calibrations]));
  if (session.motion) studio.motion.lists.learn(session.motion);
  if (session.trajectory) studio.timeline.trajectories.learn(session.trajectory);
  studio.display.set(linked.display);
  studio.document.commit("session", () => linked.document);
  studio.notify("note", `${file.name} is open.`);
}
