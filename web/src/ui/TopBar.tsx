import { useRef } from "preact/hooks";
import { withScene } from "../state/document";
import { openFiles } from "../studio/files";
import { unposed } from "../studio/robot";
import { copyText } from "../util/away";
import { useStore } from "../util/store";
import { Button } from "./controls";
import { useApp } from "./context";
import { ExportMenu } from "./ExportMenu";

const THEMES = { auto: "dark", dark: "light", light: "auto" } as const;

/** The bar at the top: the scene, undo, export and settings. */
export function TopBar({ onHelp }: { onHelp: () => void }) {
  const { studio } = useApp();
  const scene = useStore(studio.scene);
  const display = useStore(studio.display);
  const catalog = useStore(studio.catalog);
  useStore(studio.document);
  const input = useRef<HTMLInputElement>(null);
  const copyLink = () => copyText(studio.link()).then(
    () => studio.notify("note", "The link is in the clipboard. It restores this state."),
    (error) => studio.report("Copying the link", error),
  );
  const toFirst = () => studio.document.commit("scene", (document) => withScene(document, catalog.scene));
  return (
    <header class="top-bar">
      <Button icon="left" label="Controls (1)" isOn={display.showLeft} onClick={() => studio.show({ showLeft: !display.showLeft })} />
      <h1><b>oaktwin</b> studio</h1>
      <div class="scene-name">
        <span data-testid="scene">{scene?.name ?? "Loading…"}</span>
        {scene && <span class="detail">{scene.triangles.toLocaleString("en")} triangles</span>}
      </div>
      <Button icon="open" label="Open…" isNamed tip="Open a scene, a robot, its postures, a calibration, a trajectory or a session; or drop the file onto the page" onClick={() => input.current?.click()} />
      <input
        ref={input}
        type="file"
        hidden
        multiple
        data-testid="file"
        onChange={(event) => {
          void openFiles(studio, [...(event.currentTarget.files ?? [])]);
          event.currentTarget.value = "";
        }}
      />
      {scene && unposed(scene.id) !== catalog.scene && <Button label="First scene" class="text" onClick={toFirst} />}
      <span class="spring" />
      <ConnectionState />
      <Button icon="undo" label="Undo (Ctrl+Z)" isDisabled={!studio.document.canUndo} onClick={() => studio.document.undo()} testId="undo" />
      <Button icon="redo" label="Redo (Ctrl+Shift+Z)" isDisabled={!studio.document.canRedo} onClick={() => studio.document.redo()} testId="redo" />
      <ExportMenu />
      <Button icon="link" label="Copy a link to this state" onClick={copyLink} testId="link" />
      <Button icon="theme" label={`Theme: ${display.theme}`} onClick={() => studio.show({ theme: THEMES[display.theme] })} testId="theme" />
      <Button icon="help" label="Keys and help (?)" onClick={onHelp} testId="help" />
      <Button icon="right" label="Numbers (2)" isOn={display.showRight} onClick={() => studio.show({ showRight: !display.showRight })} />
    </header>
  );
}

function ConnectionState() {
  const { studio } = useApp();
  const connection = useStore(studio.connection);
  const text = { open: "Connected", connecting: "Connecting…", lost: "No connection; trying again…" }[connection];
  return (
    <span class={`connection ${connection}`} role="status" data-testid="connection">
      <span class="dot-small" />{connection !== "open" && text}
      {connection === "open" && <span class="sr-only">{text}</span>}
    </span>
  );
}
