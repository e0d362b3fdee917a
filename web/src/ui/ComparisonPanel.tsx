import { useEffect, useState } from "preact/hooks";
import { css, oakColor } from "../gpu/colormaps";
import { correspondence } from "../gpu/difference";
import type { Compared } from "../gpu/painter";
import type { Scales } from "../gpu/scales";
import type { Comparison, Side } from "../state/display";
import type { Oak } from "../state/document";
import { useStore } from "../util/store";
import { grid } from "./arrangement";
import { useApp } from "./context";
import { Marks } from "./Marks";
import { aspectOf, Fineness, StateOf, titleOf } from "./Panel";
import { Picture } from "./Picture";
import { Surface } from "./Surface";

/** How long each of two images is shown in turns, ms. */
const BLINK = 700;

interface Found extends Side {
  state: Oak;
  index: number;
}

/** Two images in one panel. */
export function ComparisonPanel({ comparison, size, scales }: { comparison: Comparison; size: { width: number; height: number }; scales: Scales }) {
  const { studio } = useApp();
  const frames = useStore(studio.frames);
  const { oaks } = useStore(studio.document);
  const { wipeAt } = useStore(studio.display);
  const catalog = useStore(studio.catalog);
  const isSecond = useTurns(comparison.mode === "blink");
  const find = (side: Side): Found | null => {
    const index = oaks.findIndex(({ key, isHidden }) => key === side.oak && !isHidden);
    const state = oaks[index];
    return state ? { ...side, state, index } : null;
  };
  const [left, right] = [find(comparison.left), find(comparison.right)];
  if (!left || !right) return <p class="hint pad">Choose two images of OAKs that are shown.</p>;
  const frame = frames.get(left.oak);
  const aspect = aspectOf(frame);
  const { width } = grid(size.width, size.height, aspect, 1, 1);
  const height = Math.round(width / aspect);
  const { mode } = comparison;
  const compared = (one: Found, other: Found): Compared | undefined => {
    const [own, others] = [frames.get(one.oak), frames.get(other.oak)];
    const found = own && others && correspondence(own, others, catalog);
    const colors = [one, other].flatMap(({ index }) => oakColor(index).map((value) => value / 255));
    return found ? { ...found, oak: other.oak, frame: others, colors } : undefined;
  };
  const shared = { width, height, isZoomed: true, scales };
  const front = mode === "blink" && isSecond ? right : left;
  // Two names in a line have room for what tells the images apart.
  const named = ({ state: { state }, kind }: Found) => {
    if (mode === "difference" || (mode === "wipe" && left.kind === right.kind && left.oak !== right.oak)) return state.model;
    return mode === "wipe" && left.oak === right.oak ? titleOf(kind) : `${state.model}: ${titleOf(kind)}`;
  };
  const title = (side: Found) => (
    <span class="compared">
      <span class="dot-small" style={{ background: css(oakColor(side.index)) }} />
      {named(side)}
    </span>
  );
  const name = `${titleOf(left.kind)} of ${left.state.state.model} and ${titleOf(right.kind)} of ${right.state.state.model}`;
  return (
    <div class="grid" style={{ gridTemplateColumns: `${width}px` }}>
      <figure class="panel" data-testid="panel-comparison">
        <figcaption>
          {mode === "blink" ? title(front) : <>{title(left)}<span class="panel-fact">{mode === "difference" ? "against" : "|"}</span>&nbsp;&nbsp;{title(right)}</>}
          <span class="spring" />
          {frame && <Fineness frame={frame} />}
        </figcaption>
        <Surface oak={front.oak} label={mode === "difference" ? `Difference of errors: ${name}` : name} width={width} height={height} isZoomed onChoose={() => {}} isChosenByClick={false}>
          {mode === "difference"
            ? frames.has(right.oak) && <Picture oak={left.oak} kind="error" frame={frame} compared={compared(left, right)} {...shared} />
            : <Picture key={front.oak + front.kind} oak={front.oak} kind={front.kind} frame={frames.get(front.oak)} {...shared} />}
          {mode === "wipe" && (
            <>
              <div class="wiped" style={{ clipPath: `inset(0 0 0 ${wipeAt * 100}%)` }}>
                <Picture oak={right.oak} kind={right.kind} frame={frames.get(right.oak)} {...shared} />
              </div>
              <Edge at={wipeAt} width={width} />
            </>
          )}
          <Marks oak={front.oak} kind={front.kind} isZoomed />
          <StateOf oak={front.state} />
          {mode === "difference" && <StateOf oak={right.state} />}
        </Surface>
      </figure>
    </div>
  );
}

/** Becomes true and false in turns. */
function useTurns(isOn: boolean): boolean {
  const [isSecond, setSecond] = useState(false);
  useEffect(() => {
    if (!isOn) return;
    const timer = setInterval(() => setSecond((before) => !before), BLINK);
    return () => clearInterval(timer);
  }, [isOn]);
  return isOn && isSecond;
}

/** The edge of a wipe, which the mouse moves; the slider above the images does it by keyboard. */
function Edge({ at, width }: { at: number; width: number }) {
  const { studio } = useApp();
  const grab = (event: PointerEvent) => {
    event.stopPropagation();
    const start = event.clientX;
    const move = (next: PointerEvent) => studio.show({ wipeAt: Math.max(0, Math.min(1, at + (next.clientX - start) / width)) });
    addEventListener("pointermove", move);
    addEventListener("pointerup", () => removeEventListener("pointermove", move), { once: true });
  };
  return <div class="edge" style={{ left: `${at * 100}%` }} onPointerDown={grab} />;
}
