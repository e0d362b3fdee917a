import type { ImageName } from "../protocol";
import type { DepthMap } from "../gpu/colormaps";

/** What an image panel shows. */
export type PanelKind = "color" | "depth" | "sensor" | "error" | "confidence" | "left" | "right" | "reason";

export const PANELS: { kind: PanelKind; title: string; help: string; images: ImageName[] }[] = [
  { kind: "color", title: "Colour", help: "The colour image in the view of the depth sensor", images: ["color"] },
  { kind: "depth", title: "Exact depth", help: "The true distance along the optical axis", images: ["depth", "reference"] },
  { kind: "sensor", title: "Sensor depth", help: "The depth that the OAK measures", images: ["sensor"] },
  { kind: "error", title: "Error", help: "Measured minus true depth", images: ["sensor", "depth", "reference"] },
  { kind: "confidence", title: "Confidence", help: "How sure the matcher is of each pixel; not made by every engine", images: ["confidence"] },
  { kind: "left", title: "Left", help: "The rectified infrared image of the left camera", images: ["left"] },
  { kind: "right", title: "Right", help: "The rectified infrared image of the right camera", images: ["right"] },
  { kind: "reason", title: "Reasons", help: "Why a pixel has no value", images: ["reason"] },
];

/** The size of the images while nothing moves. */
export type FullSize = "small" | "large" | "native";

export const FULL_SIZES: { size: FullSize; title: string; limit: [number, number] | null }[] = [
  { size: "small", title: "640 × 400", limit: [640, 400] },
  { size: "large", title: "1280 × 800", limit: [1280, 800] },
  { size: "native", title: "Native", limit: null },
];

export type CloudSource = "none" | "truth" | "measurement" | "both";
export type CloudColor = "depth" | "error" | "reason" | "oak";

/** An image of an OAK that is compared. */
export interface Side {
  /** The key of the OAK. */
  oak: string;
  kind: PanelKind;
}

/** Two images in one panel: beside a movable edge, in turns, or by what the errors of their OAKs differ. */
export interface Comparison {
  mode: "wipe" | "blink" | "difference";
  left: Side;
  right: Side;
}

export const COMPARISONS: { mode: Comparison["mode"]; title: string; help: string }[] = [
  { mode: "wipe", title: "Wipe", help: "Two images in one panel with a movable edge" },
  { mode: "blink", title: "Blink", help: "Two images in one panel in turns" },
  { mode: "difference", title: "Difference", help: "Which of two OAKs has the smaller error, at each point that the first one sees" },
];

/** How the page shows things. Nothing of it changes a result, so it is not undone. */
export interface Display {
  theme: "auto" | "light" | "dark";
  panels: PanelKind[];
  /** Whether one image of each OAK is large and the others are thumbnails, or all have one size. */
  arrangement: "large" | "grid";
  /** The large image. */
  focus: PanelKind;
  /** Two images in one panel; null for images side by side. */
  comparison: Comparison | null;
  /** Where the edge of the wipe is, as a fraction of the width. */
  wipeAt: number;
  depthMap: DepthMap;
  /** Metres; null to follow the images. */
  depthRange: [number, number] | null;
  /** The end of the error scale, metres or percent; null to follow the images. */
  errorRange: number | null;
  errorUnit: "mm" | "%";
  fullSize: FullSize;
  showCameras: boolean;
  showRanges: boolean;
  showGrid: boolean;
  showScene: boolean;
  /** Whether the 3D view shows what is above the OAK and covers it. */
  showRoof: boolean;
  cloud: CloudSource;
  cloudColor: CloudColor;
  /** The largest error of a point that coverage counts as measured, mm; null for any. */
  toleranceMm: number | null;
  /** Whether the 3D view shows what the selected OAK measures of the region's surface. */
  paintsCoverage: boolean;
  /** The share of the page's height that the 3D view has. */
  split: number;
  /** Whether the page offers first steps. */
  showStart: boolean;
  showLeft: boolean;
  showRight: boolean;
  /** The widths of the side bars, in units of the page's font. */
  leftWidth: number;
  rightWidth: number;
}

/** The least and the largest width of a side bar. */
export const SIDE_WIDTHS = [15, 45] as const;

export const DEFAULT_DISPLAY: Display = {
  theme: "auto",
  panels: ["color", "depth", "sensor", "error"],
  arrangement: "large",
  focus: "sensor",
  comparison: null,
  wipeAt: 0.5,
  depthMap: "viridis",
  depthRange: null,
  errorRange: null,
  errorUnit: "mm",
  fullSize: "large",
  showCameras: true,
  showRanges: true,
  showGrid: true,
  showScene: true,
  showRoof: false,
  cloud: "none",
  cloudColor: "error",
  toleranceMm: null,
  paintsCoverage: true,
  split: 0.46,
  showStart: true,
  showLeft: true,
  showRight: true,
  leftWidth: 21.5,
  rightWidth: 22,
};

const STORAGE_KEY = "oaktwin-studio-display";

/** Reads the settings of the last visit; unknown ones are ignored and missing ones get their defaults. */
export function loadDisplay(): Display {
  try {
    return displayFrom(JSON.parse(localStorage.getItem(STORAGE_KEY) ?? "{}"));
  } catch {
    return DEFAULT_DISPLAY;
  }
}

export function saveDisplay(display: Display): void {
  try {
    localStorage.setItem(STORAGE_KEY, JSON.stringify(display));
  } catch {
    // Storage may be disabled; the settings then last as long as the page.
  }
}

/** Makes settings of parsed JSON that may have any content. */
export function displayFrom(json: unknown): Display {
  const display = { ...DEFAULT_DISPLAY };
  if (typeof json !== "object" || json === null) return display;
  for (const [key, value] of Object.entries(json)) {
    if (isValid(key as keyof Display, value)) Object.assign(display, { [key]: value });
  }
  return display;
}

const CHOICES: Partial<Record<keyof Display, readonly unknown[]>> = {
  theme: ["auto", "light", "dark"],
  arrangement: ["large", "grid"],
  focus: PANELS.map(({ kind }) => kind),
  depthMap: ["viridis", "cividis", "turbo", "grey"],
  errorUnit: ["mm", "%"],
  fullSize: ["small", "large", "native"],
  cloud: ["none", "truth", "measurement", "both"],
  cloudColor: ["depth", "error", "reason", "oak"],
};

function isKind(kind: unknown): boolean {
  return PANELS.some((panel) => panel.kind === kind);
}

function isComparison(value: unknown): boolean {
  const isSide = (side: Side | undefined) => isKind(side?.kind) && typeof side?.oak === "string";
  const { mode, left, right } = value as Partial<Comparison>;
  return COMPARISONS.some((one) => one.mode === mode) && isSide(left) && isSide(right);
}

function isValid(key: keyof Display, value: unknown): boolean {
  switch (key) {
    case "panels":
      return Array.isArray(value) && value.every(isKind);
    case "comparison":
      return value === null || isComparison(value);
    case "leftWidth":
    case "rightWidth":
      return Number.isFinite(value) && (value as number) >= SIDE_WIDTHS[0] && (value as number) <= SIDE_WIDTHS[1];
    case "depthRange":
      return value === null || (Array.isArray(value) && value.length === 2 && value.every(Number.isFinite));
    case "errorRange":
    case "toleranceMm":
      return value === null || (Number.isFinite(value) && (value as number) > 0);
    case "wipeAt":
    case "split":
      return Number.isFinite(value) && (value as number) >= 0 && (value as number) <= 1;
    default:
      return CHOICES[key]?.includes(value) ?? (key in DEFAULT_DISPLAY && typeof value === typeof DEFAULT_DISPLAY[key]);
  }
}

/** Returns the images that are shown, in the order of {@link PANELS}. */
export function shownKinds({ panels, focus, arrangement, comparison }: Display): PanelKind[] {
  if (comparison) return [...new Set([comparison.left.kind, comparison.right.kind])];
  return PANELS.map(({ kind }) => kind).filter((kind) => panels.includes(kind) || (arrangement === "large" && kind === focus));
}
