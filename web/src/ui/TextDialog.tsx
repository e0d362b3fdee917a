import { useState } from "preact/hooks";
import { copyText } from "../util/away";
import { useStore } from "../util/store";
import { Button } from "./controls";
import { useApp } from "./context";
import { Dialog } from "./Dialog";

/** A command or a script to be copied. */
export function TextDialog({ title, text, onClose }: { title: string; text: string; onClose: () => void }) {
  const { studio } = useApp();
  const scene = useStore(studio.scene);
  const [isCopied, setCopied] = useState(false);
  const copy = () => copyText(text).then(() => setCopied(true), (error) => studio.report("Copying", error));
  return (
    <Dialog title={title} onClose={onClose}>
      {scene?.id.startsWith("dropped-") && <p class="hint">{`Run this in the folder of ${scene.robot ? "the dropped files" : scene.name}.`}</p>}
      <pre class="code" tabIndex={0} data-testid="snippet">{text}</pre>
      <div class="row spread"><Button icon="copy" label={isCopied ? "Copied" : "Copy"} isNamed onClick={copy} class="primary" /></div>
    </Dialog>
  );
}
