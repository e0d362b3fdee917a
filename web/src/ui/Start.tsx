import { useState } from "preact/hooks";
import { addOak, defaultState, findModel, MAX_OAKS, type StudioDocument } from "../state/document";
import type { Studio } from "../studio/studio";
import { useStore } from "../util/store";
import { Button } from "./controls";
import { type App, useApp } from "./context";

interface Choice {
  title: string;
  tip: string;
  run: (app: App) => void;
}

/** Models that are compared often. */
const SETS: { title: string; models: string[] }[] = [
  { title: "OAK-D Lite, OAK-D Pro, OAK4-D", models: ["OAK-D Lite", "OAK-D Pro", "OAK4-D"] },
  { title: "Stereo and time of flight", models: ["OAK4-D", "OAK-D ToF"] },
  { title: "Short and long range", models: ["OAK-D SR", "OAK-D", "OAK-D LR"] },
];

const STARTS: { title: string; question: string; choices: Choice[] }[] = [
  {
    title: "Compare cameras",
    question: "Which ones? They stand at the same pose.",
    choices: SETS.map(({ title, models }) => ({ title, tip: models.join(", "), run: ({ studio }) => compare(studio, models) })),
  },
  {
    title: "Why are there holes?",
    question: "In which light?",
    choices: [
      { title: "By day", tip: "In the scene's own light", run: ({ studio }) => explain(studio, 1) },
      { title: "At night", tip: "Without any light but the projector's", run: ({ studio }) => explain(studio, 0) },
    ],
  },
  {
    title: "Where do I mount it?",
    question: "What must it see?",
    choices: [
      { title: "Click an object", tip: "The next click in the 3D view chooses it", run: pick },
      { title: "Choose from a list", tip: "The objects of the scene by their paths", run: ({ studio }) => { studio.tab.set("place"); focusOn("target"); } },
    ],
  },
];

/** Replaces the OAKs by models at the pose of the selected one. */
function compare(studio: Studio, names: string[]): void {
  studio.tab.set("inspect");
  studio.show({ comparison: null, arrangement: "large", focus: "sensor" });
  studio.document.commit("start", (document) => {
    const pose = document.oaks.find(({ key }) => key === document.selected)?.state.pose;
    const models = names.map((name) => findModel(studio.catalog.get(), name)).filter((model) => model !== undefined);
    if (!pose || models.length === 0) return document;
    const empty: StudioDocument = { ...document, oaks: [], selected: "", arePosesLinked: true };
    const filled = models.slice(0, MAX_OAKS).reduce((next, model) => addOak(next, defaultState(model, pose)), empty);
    return { ...filled, selected: filled.oaks[0]?.key ?? "" };
  });
}

/** Shows the reasons of all OAKs in a light. */
function explain(studio: Studio, ambient: number): void {
  studio.tab.set("inspect");
  const { panels } = studio.display.get();
  studio.show({ comparison: null, arrangement: "large", focus: "reason", panels: panels.includes("reason") ? panels : [...panels, "reason"] });
  studio.document.commit("start", (document) => ({ ...document, oaks: document.oaks.map((oak) => ({ ...oak, state: { ...oak.state, ambient } })) }));
}

function pick({ studio, view }: App): void {
  studio.tab.set("place");
  view.get()?.isPicking.set(true);
}

/** Puts the focus into a field of a part of the page that is shown next. */
function focusOn(testId: string): void {
  requestAnimationFrame(() => requestAnimationFrame(() => document.querySelector<HTMLElement>(`[data-testid="${testId}"]`)?.focus()));
}

/** Three questions that lead to a first result. */
export function Start() {
  const app = useApp();
  const { studio } = app;
  const { showStart } = useStore(studio.display);
  const [at, setAt] = useState<number | null>(null);
  if (!showStart) return null;
  const start = at === null ? null : STARTS[at];
  const run = (choice: Choice) => {
    setAt(null);
    studio.show({ showRight: true });
    choice.run(app);
  };
  return (
    <div class="start" role="region" aria-label="First steps" data-testid="start">
      {start && <span class="name">{start.question}</span>}
      {start
        ? start.choices.map((choice) => <Button key={choice.title} label={choice.title} class="chip primary" tip={choice.tip} onClick={() => run(choice)} />)
        : STARTS.map(({ title }, i) => <Button key={title} label={title} class="chip" onClick={() => setAt(i)} />)}
      {start && <Button icon="undo" label="Back" class="small" onClick={() => setAt(null)} />}
      <Button icon="close" label="Do not show this again" class="small" onClick={() => studio.show({ showStart: false })} />
    </div>
  );
}
