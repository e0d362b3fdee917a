import type { ComponentChildren } from "preact";
import { useLayoutEffect, useRef } from "preact/hooks";
import { Button } from "./controls";

/** A modal dialogue; Escape closes it and the focus returns to where it was. */
export function Dialog({ title, children, onClose, isNarrow = false }: { title: string; children: ComponentChildren; onClose: () => void; isNarrow?: boolean }) {
  const element = useRef<HTMLDialogElement>(null);
  // Before the next frame: a key pressed as soon as the text appears must reach the dialogue.
  useLayoutEffect(() => {
    const dialog = element.current;
    const before = document.activeElement;
    dialog?.showModal();
    return () => {
      dialog?.close();
      // A dialogue that is removed while it is open does not give the focus back by itself; a menu whose entry opened it is closed.
      const isThere = before instanceof HTMLElement && before.isConnected && before !== document.body;
      (isThere ? before : document.querySelector<HTMLElement>('[data-testid="view"]'))?.focus();
    };
  }, []);
  return (
    <dialog
      ref={element}
      class={`dialog ${isNarrow ? "narrow" : ""}`}
      aria-label={title}
      onClose={onClose}
      onClick={(event) => event.target === element.current && onClose()}
    >
      <div class="dialog-head">
        <h2>{title}</h2>
        <Button icon="close" label="Close" onClick={onClose} />
      </div>
      <div class="dialog-body">{children}</div>
    </dialog>
  );
}
