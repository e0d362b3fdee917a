import { useState } from "preact/hooks";
import { saveSession } from "../studio/session";
import { fit } from "../studio/frames";
import { api, type Exported } from "../net/api";
import type { ExportRequest, OakState } from "../protocol";
import { FULL_SIZES, type PanelKind, PANELS, shownKinds } from "../state/display";
import { findSensor, selectedOak, sceneAt } from "../state/document";
import type { Studio } from "../studio/studio";
import { save } from "../util/away";
import { words } from "../util/format";
import { useStore } from "../util/store";
import { captionedImage } from "./caption";
import { type App, useApp } from "./context";
import { Menu } from "./Menu";
import { TextDialog } from "./TextDialog";
import { composePanels } from "./compose";

type What = Omit<ExportRequest, "scene" | "state" | "size">;

const FILES: { title: string; what: What }[] = [
  { title: "Asset (USD)", what: { what: "asset", format: "usda" } },
  { title: "Asset (USDZ)", what: { what: "asset", format: "usdz" } },
  { title: "Statistics (JSON)", what: { what: "statistics", format: "json" } },
  { title: "Statistics (CSV)", what: { what: "statistics", format: "csv" } },
  { title: "Parameters (TOML)", what: { what: "parameters" } },
];
const TEXTS: { title: string; what: What }[] = [
  { title: "Command line…", what: { what: "command" } },
  { title: "Python…", what: { what: "python" } },
];

/** Asks the server for something to take away from the selected OAK. */
async function exported(studio: Studio, what: What): Promise<Exported | null> {
  const document = studio.document.get();
  const oak = selectedOak(document);
  const sensor = oak && findSensor(studio.catalog.get(), oak.state);
  if (!oak || !sensor) return null;
  const limit = FULL_SIZES.find(({ size }) => size === studio.display.get().fullSize)?.limit ?? null;
  const sized = (state: OakState) => ({ state, size: fit(findSensor(studio.catalog.get(), state)?.resolution ?? [1, 1], limit) });
  const shown = document.oaks.filter((other) => other.key !== oak.key && !other.isHidden && studio.hasDepth(other.state));
  const compared = what.what === "statistics" ? { region: document.region, others: shown.map(({ state }) => sized(state)) } : {};
  try {
    return await api.export({ ...what, ...compared, ...timed(studio), scene: sceneAt(document), ...sized(oak.state) });
  } catch (error) {
    studio.report("The export", error);
    return null;
  }
}

/** What commands need to know of the timeline. */
function timed(studio: Studio): Pick<ExportRequest, "trajectory" | "codes"> {
  const { trajectory } = studio.document.get();
  const codes = studio.timeline.frames()?.codes;
  return { ...(trajectory !== null && { trajectory }), ...(codes && { codes: [codes.first, codes.step] }) };
}

/** Saves all panels in one picture, as they are on the page. */
async function saveShown(studio: Studio): Promise<void> {
  const picture = await composePanels(document);
  if (picture) save("oaktwin-images.png", picture);
  else studio.notify("warning", "No image is shown.");
}

/** Saves an image of the selected OAK with its scale and a caption. */
async function saveCaptioned(app: App, kind: PanelKind): Promise<void> {
  const { studio } = app;
  const oak = selectedOak(studio.document.get());
  const picture = oak && (await captionedImage(app, oak.key, kind));
  if (picture) save(`oaktwin-${oak.state.model.toLowerCase().replaceAll(" ", "-")}-${kind}.png`, picture);
  else studio.notify("warning", "This image is not available.");
}

const EXACT = "The exact values; lengths are metres as 32-bit floating-point numbers";

/** The title of a format of robots: abbreviations in capitals. */
function robotTitle(name: string): string {
  return `${name.length <= 4 ? name.toUpperCase() : words(name)} (ZIP)`;
}

/** What can be taken away: files of the selected OAK, and texts that reproduce its state. */
export function ExportMenu() {
  const app = useApp();
  const { studio } = app;
  const display = useStore(studio.display);
  const [text, setText] = useState<{ title: string; text: string } | null>(null);
  const images = PANELS.filter(({ kind }) => shownKinds(display).includes(kind));
  const download = async (what: What) => {
    const answer = await exported(studio, what);
    if (!answer) return;
    save(answer.name, answer.file);
    if (answer.findings.length) studio.notify("note", `${answer.name} is saved.`, answer.findings);
  };
  const show = async (title: string, what: What) => {
    const answer = await exported(studio, what);
    if (answer) setText({ title: title.replace("…", ""), text: await answer.file.text() });
  };
  return (
    <>
      <Menu icon="download" label="Export" testId="export">
        {(close) => {
          const item = (title: string, run: () => void, tip?: string) => (
            <button key={title} type="button" role="menuitem" class="menu-item" data-tip={tip} onClick={() => { close(); run(); }}>{title}</button>
          );
          return (
            <>
              <p class="menu-head">Reproduce this state</p>
              {item("Session, to open it here again", () => void saveSession(studio), "One file with everything on this page, and the files that were dropped onto it")}
              {TEXTS.map(({ title, what }) => item(title, () => void show(title, what)))}
              <p class="menu-head">Files</p>
              {FILES.map(({ title, what }) => item(title, () => void download(what)))}
              <p class="menu-head">Robots and simulators</p>
              {studio.catalog.get().robotFormats.map(({ name, help }) => item(robotTitle(name), () => void download({ what: "robot", format: name }), help))}
              <p class="menu-head">Images</p>
              {item("As shown (PNG)", () => void saveShown(studio))}
              {images.map(({ kind, title }) => item(`${title} with its scale (PNG)`, () => void saveCaptioned(app, kind), "In full resolution, with a caption, for a report"))}
              {images.flatMap(({ kind, title, images: [image] }) => (image === undefined ? [] : kind === "error" ? [
                item(`${title} (NumPy)`, () => void download({ what: "error" }), EXACT),
              ] : [
                item(`${title} (PNG)`, () => void download({ what: "image", image, format: "png" })),
                item(`${title} (NumPy)`, () => void download({ what: "image", image, format: "npy" }), EXACT),
              ]))}
            </>
          );
        }}
      </Menu>
      {text && <TextDialog title={text.title} text={text.text} onClose={() => setText(null)} />}
    </>
  );
}
