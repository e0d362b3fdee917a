import { type Comparison, COMPARISONS, type Display, FULL_SIZES, type PanelKind, PANELS, type Side } from "../state/display";
import type { StudioDocument } from "../state/document";
import { useStore } from "../util/store";
import { NO_ZOOM } from "../util/zoom";
import { Button, Select } from "./controls";
import { useApp } from "./context";
import { titleOf } from "./Panel";

/** The choice of the images that are shown, and of how. */
export function ImageBar() {
  const { studio } = useApp();
  const display = useStore(studio.display);
  const document = useStore(studio.document);
  const zoom = useStore(studio.zoom);
  const maximized = useStore(studio.maximized);
  const { comparison, arrangement } = display;
  const setMode = (mode: Comparison["mode"] | "none") => {
    studio.maximized.set(null);
    studio.show({ comparison: mode === "none" ? null : { ...(comparison ?? firstSides(display, document)), mode } });
  };
  return (
    <div class="bar" role="toolbar" aria-label="Images that are shown">
      {comparison ? <Sides comparison={comparison} /> : <Kinds />}
      <div class="bar-end">
        {zoom.scale > 1 && (
          <Button label={`${zoom.scale.toFixed(1)}×`} class="chip" tip="Show the whole image (0). The wheel zooms; Shift and dragging moves the image." onClick={() => studio.zoom.set(NO_ZOOM)} testId="zoom" />
        )}
        {maximized && <Button label="Restore" class="chip" tip="Show the 3D view and the other images again (Escape)" isOn onClick={() => studio.maximized.set(null)} testId="restore" />}
        {!comparison && !maximized && (
          <Button
            label="Grid"
            class="chip"
            tip="All images in one size, instead of a large one of each OAK with thumbnails"
            isOn={arrangement === "grid"}
            onClick={() => studio.show({ arrangement: arrangement === "grid" ? "large" : "grid" })}
            testId="grid"
          />
        )}
        <Select
          label="Comparison"
          isLabelled={false}
          value={comparison?.mode ?? "none"}
          options={[{ value: "none" as const, title: "Side by side" }, ...COMPARISONS.map(({ mode, title }) => ({ value: mode, title }))]}
          onChange={setMode}
          testId="comparison"
        />
        <Select
          label="Image size at rest"
          isLabelled={false}
          value={display.fullSize}
          options={FULL_SIZES.map(({ size, title }) => ({ value: size, title }))}
          onChange={(fullSize) => studio.show({ fullSize })}
          testId="full-size"
        />
      </div>
    </div>
  );
}

function Kinds() {
  const { studio } = useApp();
  const display = useStore(studio.display);
  const toggle = (kind: PanelKind) => {
    const isOn = display.panels.includes(kind);
    const panels = isOn ? display.panels.filter((other) => other !== kind) : [...display.panels, kind];
    // What is added is what somebody wants to see; what is removed cannot stay large.
    const focus = isOn ? (display.focus === kind ? panels[0] : display.focus) : kind;
    studio.maximized.set(null);
    studio.show({ panels, focus: focus ?? display.focus });
  };
  return PANELS.map(({ kind, title, help }) => (
    <Button key={kind} label={title} class="chip" tip={help} isOn={display.panels.includes(kind)} onClick={() => toggle(kind)} testId={`show-${kind}`} />
  ));
}

/** The first comparison: of two OAKs, or of what one OAK measures with the truth. */
function firstSides({ focus }: Display, { oaks, selected }: StudioDocument): Pick<Comparison, "left" | "right"> {
  const [first, second] = oaks.filter(({ isHidden }) => !isHidden);
  const other = oaks.find(({ key, isHidden }) => key === selected && key !== first?.key && !isHidden) ?? second;
  if (first && other) return { left: { oak: first.key, kind: focus }, right: { oak: other.key, kind: focus } };
  return { left: { oak: selected, kind: "depth" }, right: { oak: selected, kind: "sensor" } };
}

/** The choice of the two images that are compared. */
function Sides({ comparison }: { comparison: Comparison }) {
  const { studio } = useApp();
  const { wipeAt } = useStore(studio.display);
  const { oaks } = useStore(studio.document);
  const shown = oaks.map((oak, index) => ({ oak, index })).filter(({ oak }) => !oak.isHidden);
  const isDifference = comparison.mode === "difference";
  const encode = ({ oak, kind }: Side) => (isDifference ? oak : `${oak}/${kind}`);
  const decode = (text: string): Side => {
    const [oak = "", kind = "error"] = text.split("/");
    return { oak, kind: kind as PanelKind };
  };
  const named = (model: string, index: number) => (oaks.length > 1 ? `${index + 1} ${model}` : model);
  const options = shown.flatMap(({ oak, index }) => (isDifference
    ? [{ value: oak.key, title: named(oak.state.model, index) }]
    : PANELS.map(({ kind }) => ({ value: `${oak.key}/${kind}`, title: oaks.length > 1 ? `${named(oak.state.model, index)}: ${titleOf(kind)}` : titleOf(kind) }))));
  const side = (name: "left" | "right", label: string) => (
    <Select
      label={label}
      isLabelled={false}
      value={encode(comparison[name])}
      options={options}
      onChange={(text) => studio.show({ comparison: { ...comparison, [name]: isDifference ? { ...decode(text), kind: comparison[name].kind } : decode(text) } })}
      testId={`compared-${name}`}
    />
  );
  return (
    <>
      {side("left", "First image")}
      {comparison.mode === "wipe" && (
        <input
          type="range"
          class="wipe-at"
          min={0}
          max={1}
          step={0.01}
          aria-label="Edge of the wipe"
          value={wipeAt}
          onInput={(event) => studio.show({ wipeAt: Number(event.currentTarget.value) })}
        />
      )}
      {comparison.mode !== "wipe" && <span class="name">{isDifference ? "against" : "and"}</span>}
      {side("right", "Second image")}
    </>
  );
}
