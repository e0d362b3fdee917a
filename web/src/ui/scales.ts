import { useRef } from "preact/hooks";
import { findScales, type Scales } from "../gpu/scales";
import type { Display } from "../state/display";
import type { Shown } from "../studio/studio";

/** A scale of a preview that differs by no more than this factor leaves the one before, so that colours do not flicker. */
const CHANGE = 2;

/** Returns the scales that all images share. While previews are shown, they stay unless they no longer suit. */
export function useScales(frames: ReadonlyMap<string, Shown>, display: Display): Scales {
  const last = useRef<{ frames: unknown; display: unknown; scales: Scales } | null>(null);
  const before = last.current;
  if (before && before.frames === frames && before.display === display) return before.scales;
  const found = findScales(frames.values(), display);
  const isPreview = [...frames.values()].some((frame) => frame.isPreview);
  const scales = before && isPreview ? steady(before.scales, found, display) : found;
  last.current = { frames, display, scales };
  return scales;
}

function steady(before: Scales, found: Scales, { depthRange, errorRange }: Display): Scales {
  const isNear = (a: number, b: number) => Math.max(a, b) <= CHANGE * Math.min(a, b);
  const size = ([from, to]: [number, number]) => to - from;
  const isDepthKept = depthRange === null && isNear(before.depth[1], found.depth[1]) && isNear(size(before.depth), size(found.depth));
  return {
    depth: isDepthKept ? before.depth : found.depth,
    error: errorRange === null && isNear(before.error, found.error) ? before.error : found.error,
  };
}
