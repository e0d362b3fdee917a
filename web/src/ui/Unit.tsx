import type { OakState } from "../protocol";
import { useStore } from "../util/store";
import { Button, Check, NumberField, Section, Select } from "./controls";
import { useApp } from "./context";
import { ParameterField } from "./ParameterField";

/** The share of a drift's range that its slider covers: the rest is rare. */
const REACH = 0.1;
const MAX_SEED = 4294967295;
/** The device that is a unit of the population; ids of calibrations begin with another word. */
const POPULATION = "population";

type Problem = (field: string) => string | undefined;

/** What differs from one device to the next, and from one image to the next. */
export function UnitSection({ state, problem }: { state: OakState; problem: Problem }) {
  const { studio } = useApp();
  const set = (tag: string, change: Partial<OakState>) => studio.change(tag, (state) => ({ ...state, ...change }));
  return (
    <Section title="Noise and unit">
      <Seed
        label="Noise seed"
        tip="Images with the same seed have the same noise"
        another="Another seed"
        value={state.seed}
        onChange={(seed) => set("seed", { seed })}
        testId="seed"
      />
      <Device state={state} problem={problem} />
      <Check
        label="Calibration error"
        tip="A random error of the unit's calibration, which biases its disparity, instead of none"
        isOn={state.deviceSeed !== null}
        onChange={(isOn) => set("unit", { deviceSeed: isOn ? 1 : null })}
      />
      {state.deviceSeed !== null && (
        <Seed
          label="Seed of the error"
          tip="Each number is another error"
          another="Another error"
          value={state.deviceSeed}
          onChange={(deviceSeed) => set("deviceSeed", { deviceSeed })}
        />
      )}
    </Section>
  );
}

/** The cameras: nominal, those of a unit that is drawn, or those of a dropped calibration. */
function Device({ state, problem }: { state: OakState; problem: Problem }) {
  const { studio } = useApp();
  const calibrations = useStore(studio.calibrations);
  const chosen = state.populationSeed !== null ? POPULATION : (state.calibration ?? "");
  const choose = (id: string) => studio.change("device", (state) => {
    const isDrawn = id === POPULATION;
    return { ...state, calibration: isDrawn ? null : id || null, populationSeed: isDrawn ? (state.populationSeed ?? 1) : null };
  });
  const files = [...calibrations.values()].map(({ id, name }) => ({ value: id, title: name }));
  // A link may name a calibration that only the server still has.
  const isUnknown = state.calibration !== null && !calibrations.has(state.calibration);
  return (
    <>
      <Select
        label="Cameras"
        testId="device"
        value={chosen}
        options={[
          { value: "", title: "Nominal" },
          { value: POPULATION, title: "A unit of the population" },
          ...files,
          ...(isUnknown && state.calibration !== null ? [{ value: state.calibration, title: "A dropped calibration" }] : []),
        ]}
        onChange={choose}
      />
      {state.populationSeed !== null && (
        <Seed
          label="Unit"
          tip="Each number is another device: focal lengths, principal points, distortion and poses differ as those of factory calibrations do"
          another="Another unit"
          value={state.populationSeed}
          onChange={(populationSeed) => studio.change("populationSeed", (state) => ({ ...state, populationSeed }))}
          problem={problem("populationSeed")}
          testId="population-seed"
        />
      )}
      {calibrations.size === 0 && <p class="hint">Drop a device's calibration file here to model that device.</p>}
    </>
  );
}

/** A number that chooses something random, and a die. */
function Seed({ label, tip, another, value, onChange, problem, testId }: {
  label: string; tip: string; another: string; value: number; onChange: (value: number) => void; problem?: string | undefined; testId?: string;
}) {
  return (
    <div class="row end">
      <NumberField
        label={label}
        tip={tip}
        value={value}
        onChange={(value) => onChange(Math.round(value))}
        step={1}
        digits={0}
        minimum={0}
        maximum={MAX_SEED}
        problem={problem}
        {...(testId === undefined ? {} : { testId })}
      />
      <Button icon="dice" label={another} onClick={() => onChange(Math.floor(Math.random() * 100_000))} />
    </div>
  );
}

/** How the pair changed since its calibration. */
export function DriftSection({ state, problem }: { state: OakState; problem: Problem }) {
  const { studio } = useApp();
  const { drift } = useStore(studio.catalog);
  const set = (name: string, value: string | undefined) => studio.change(`drift ${name}`, (state) => {
    const { [name]: _, ...others } = state.drift;
    return { ...state, drift: value === undefined ? others : { ...others, [name]: value } };
  });
  const changed = Object.keys(state.drift).length;
  return (
    <Section
      title="Drift"
      testId="drift"
      isOpen={changed > 0}
      actions={changed > 0 && <Button label="Reset" class="text" onClick={() => studio.change("drift", (state) => ({ ...state, drift: {} }))} />}
    >
      <p class="hint">How the stereo pair changed since its calibration: a rotation of the right camera, or the growth of the baseline or of the focal lengths.</p>
      {drift.map((parameter) => (
        <ParameterField
          key={parameter.name}
          parameter={parameter}
          value={state.drift[parameter.name]}
          fallback={parameter.default}
          problem={problem(`drift.${parameter.name}`)}
          onChange={(value) => set(parameter.name, value)}
          reach={REACH}
        />
      ))}
    </Section>
  );
}
