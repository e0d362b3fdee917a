import type { OakState } from "../protocol";
import { reflectances } from "../state/infrared";
import { useStore } from "../util/store";
import { useApp } from "./context";
import { Check, NumberField, Section, Select } from "./controls";
import { Infrared } from "./Infrared";

/**
 * What the images of the scene show: colours as they are or as the camera records them, transparent surfaces or what is behind them, and
 * how much infrared light surfaces reflect.
 */
export function ColoursSection({ state, problem }: { state: OakState; problem: (field: string) => string | undefined }) {
  const { studio } = useApp();
  const set = (tag: string, change: Partial<OakState>) => studio.change(tag, (state) => ({ ...state, ...change }));
  const light = Number(state.colorImager?.light ?? 1);
  const setLight = (value: number) => studio.change("color light", (state) => {
    const { light: _, ...others } = state.colorImager ?? {};
    return { ...state, colorImager: value === 1 ? others : { ...others, light: String(value) } };
  });
  const { scene } = useStore(studio.document);
  const wrong = problem("colorImager") ?? problem("transparent");
  return (
    <Section title="Colours and glass" isOpen={state.colorImager !== null || state.transparent !== "surface" || reflectances(scene).length > 0}>
      <Check
        label="Recorded colours"
        tip="Colours with the blur, the exposure and the noise of the camera; grey if its sensor is monochrome"
        isOn={state.colorImager !== null}
        onChange={(isOn) => set("recorded colours", { colorImager: isOn ? {} : null })}
      />
      {state.colorImager && (
        <NumberField
          label="Light of the scene"
          tip="As a multiple of the scene's own: 0.01 is a dim room, in which exposure reaches its limits"
          value={light}
          onChange={setLight}
          step={0.1}
          digits={4}
          minimum={0}
          maximum={1000000}
        />
      )}
      <Select
        label="Ground truth of clear surfaces"
        testId="transparent"
        value={state.transparent}
        options={[{ value: "surface", title: "The surface" }, { value: "through", title: "What is behind" }]}
        onChange={(value) => set("transparent", { transparent: value === "through" ? "through" : "surface" })}
      />
      <Infrared />
      {wrong && <p class="problem" role="alert">{wrong}</p>}
    </Section>
  );
}
