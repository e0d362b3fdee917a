import { useEffect, useLayoutEffect, useRef, useState } from "preact/hooks";

const DELAY = 350;

/**
 * The one tooltip of the page, for whatever has `data-tip`: it appears for the mouse and for the keyboard, and Escape hides it.
 */
export function Tooltip() {
  const [anchor, setAnchor] = useState<HTMLElement | null>(null);
  const bubble = useRef<HTMLDivElement>(null);
  useEffect(() => {
    let timer = 0;
    const show = (event: Event, delay: number) => {
      clearTimeout(timer);
      const found = event.target instanceof Element ? event.target.closest<HTMLElement>("[data-tip]") : null;
      if (found) timer = window.setTimeout(() => setAnchor(found), delay);
      else setAnchor(null);
    };
    const hide = () => {
      clearTimeout(timer);
      setAnchor(null);
    };
    const over = (event: Event) => show(event, DELAY);
    const focus = (event: Event) => {
      if (event.target instanceof Element && event.target.matches(":focus-visible")) show(event, DELAY);
    };
    const key = (event: KeyboardEvent) => event.key === "Escape" && hide();
    document.addEventListener("pointerover", over);
    document.addEventListener("pointerdown", hide);
    document.addEventListener("focusin", focus);
    document.addEventListener("focusout", hide);
    document.addEventListener("keydown", key);
    return () => {
      hide();
      document.removeEventListener("pointerover", over);
      document.removeEventListener("pointerdown", hide);
      document.removeEventListener("focusin", focus);
      document.removeEventListener("focusout", hide);
      document.removeEventListener("keydown", key);
    };
  }, []);
  useLayoutEffect(() => {
    const element = bubble.current;
    if (!anchor || !element) return;
    place(element, anchor);
    anchor.setAttribute("aria-describedby", element.id);
    return () => anchor.removeAttribute("aria-describedby");
  }, [anchor]);
  if (!anchor?.dataset.tip) return null;
  const [first, ...rest] = anchor.dataset.tip.split("\n");
  return (
    <div ref={bubble} id="tooltip" role="tooltip" class="tooltip">
      <p>{first}</p>
      {rest.map((line) => <p key={line} class="fact">{line}</p>)}
    </div>
  );
}

/** Puts the tooltip beside the side bar of its anchor, otherwise below the anchor, or where there is room. */
function place(element: HTMLElement, anchor: HTMLElement): void {
  const around = anchor.getBoundingClientRect();
  const { width, height } = element.getBoundingClientRect();
  const side = anchor.closest(".side");
  if (side) {
    const bar = side.getBoundingClientRect();
    const isLeft = side.classList.contains("left");
    element.style.left = `${isLeft ? bar.right + 6 : bar.left - width - 6}px`;
    element.style.top = `${Math.max(8, Math.min(around.top, innerHeight - height - 8))}px`;
    return;
  }
  const left = Math.max(8, Math.min(around.left, innerWidth - width - 8));
  const below = around.bottom + 6;
  const top = below + height < innerHeight - 8 ? below : Math.max(8, around.top - height - 6);
  element.style.left = `${left}px`;
  element.style.top = `${top}px`;
}
