import type { ComponentChildren } from "preact";
import { useEffect, useRef, useState } from "preact/hooks";
import { Icon, type IconName } from "./icons";

/** A button that opens a menu. Arrow keys move in it; Escape closes it. */
export function Menu({ icon, label, children, testId }: {
  icon: IconName; label: string; children: (close: () => void) => ComponentChildren; testId?: string;
}) {
  const [isOpen, setOpen] = useState(false);
  const root = useRef<HTMLDivElement>(null);
  const button = useRef<HTMLButtonElement>(null);
  const close = () => setOpen(false);
  // The focus stays in the page when the chosen entry vanishes.
  const leave = () => {
    close();
    button.current?.focus();
  };
  useEffect(() => {
    if (!isOpen) return;
    const outside = (event: Event) => {
      if (event.target instanceof Node && !root.current?.contains(event.target)) close();
    };
    document.addEventListener("pointerdown", outside);
    root.current?.querySelector<HTMLElement>('[role="menuitem"]')?.focus();
    return () => document.removeEventListener("pointerdown", outside);
  }, [isOpen]);
  const key = (event: KeyboardEvent) => {
    if (event.key === "Escape") {
      leave();
      event.stopPropagation();
    }
    if (event.key !== "ArrowDown" && event.key !== "ArrowUp") return;
    event.preventDefault();
    const items = [...(root.current?.querySelectorAll<HTMLElement>('[role="menuitem"]') ?? [])];
    const at = items.indexOf(document.activeElement as HTMLElement);
    const next = (at + (event.key === "ArrowDown" ? 1 : -1) + items.length) % items.length;
    items[next]?.focus();
  };
  return (
    <div class="menu-root" ref={root} onKeyDown={key}>
      <button ref={button} type="button" class="button" aria-haspopup="menu" aria-expanded={isOpen} data-testid={testId} onClick={() => setOpen(!isOpen)}>
        <Icon name={icon} />
        <span>{label}</span>
      </button>
      {isOpen && <div class="menu" role="menu" aria-label={label}>{children(leave)}</div>}
    </div>
  );
}
