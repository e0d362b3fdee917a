/** Icons as paths in a box of 16 × 16. */
const PATHS = {
  add: "M8 3v10M3 8h10",
  close: "M4 4l8 8M12 4l-8 8",
  copy: "M6 6h7v7H6zM3 10V3h7",
  down: "M8 3v10M4 9l4 4 4-4",
  up: "M8 13V3M4 7l4-4 4 4",
  undo: "M6 3L3 6l3 3M3 6h6a4 4 0 010 8H6",
  redo: "M10 3l3 3-3 3M13 6H7a4 4 0 000 8h3",
  eye: "M1.5 8S4 3.5 8 3.5 14.5 8 14.5 8 12 12.5 8 12.5 1.5 8 1.5 8zM8 6a2 2 0 100 4 2 2 0 000-4z",
  hidden: "M2 2l12 12M1.5 8S4 3.5 8 3.5 14.5 8 14.5 8 12 12.5 8 12.5 1.5 8 1.5 8z",
  theme: "M8 2.5a5.5 5.5 0 100 11zM8 2.5a5.5 5.5 0 010 11",
  help: "M6 6a2 2 0 113 1.7c-.7.4-1 .8-1 1.8M8 12v.5M8 1.5a6.5 6.5 0 100 13 6.5 6.5 0 000-13z",
  open: "M2 13V3h4l1.5 2H14v8z",
  share: "M7 9l2-2M6.5 5.5L8 4a2.8 2.8 0 014 4l-1.5 1.5M9.5 10.5L8 12a2.8 2.8 0 01-4-4l1.5-1.5",
  download: "M8 2v8M4.5 7L8 10.5 11.5 7M2.5 13.5h11",
  reset: "M3 8a5 5 0 105-5H5M7 1L5 3l2 2",
  ruler: "M2 11.5l9.5-9.5 2.5 2.5-9.5 9.5zM5.5 8l1.5 1.5M8 5.5L9.5 7M10.5 3l1 1",
  picture: "M2 3h12v10H2zM4 11l3-3.5 2.5 2.5 1.5-1.5L13 11M10.5 6h.1",
  play: "M4.5 2.5v11l9-5.5z",
  pause: "M5 3v10M11 3v10",
  left: "M2 3h12v10H2zM6 3v10",
  right: "M2 3h12v10H2zM10 3v10",
  link: "M6 4H4a3 3 0 000 8h2M10 4h2a3 3 0 010 8h-2M5 8h6",
  move: "M8 1.5v13M1.5 8h13M6 3.5l2-2 2 2M6 12.5l2 2 2-2M3.5 6l-2 2 2 2M12.5 6l2 2-2 2",
  turn: "M13 5.5A5.5 5.5 0 108 13.5M13 2v3.5H9.5",
  home: "M2.5 8L8 3l5.5 5M4 7v6h8V7",
  camera: "M2 5h3l1-1.5h4L11 5h3v8H2zM8 7a2 2 0 100 4 2 2 0 000-4z",
  warning: "M8 2L1.5 13.5h13zM8 6v4M8 11.5v.6",
  dice: "M3 3h10v10H3zM6 6h.1M10 10h.1M8 8h.1M10 6h.1M6 10h.1",
} as const;

export type IconName = keyof typeof PATHS;

export function Icon({ name }: { name: IconName }) {
  return (
    <svg class="icon" viewBox="0 0 16 16" aria-hidden="true">
      <path d={PATHS[name]} />
    </svg>
  );
}
