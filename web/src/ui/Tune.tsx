import { useMemo, useRef } from "preact/hooks";
import type { DepthSensor, Engine, OakState, Parameter } from "../protocol";
import { findEngine, findModel, findSensor, type Oak, selectedOak } from "../state/document";
import { grouped } from "../state/parameters";
import { SHARED, setForAll } from "../studio/forall";
import { words } from "../util/format";
import { useSelected, useStore } from "../util/store";
import { ColoursSection } from "./Colours";
import { Button, Check, NumberField, Section, Select } from "./controls";
import { useApp } from "./context";
import { FilterList } from "./FilterList";
import { Menu } from "./Menu";
import { ParameterField } from "./ParameterField";
import { DriftSection, UnitSection } from "./Unit";

/** The controls of the selected OAK. */
export function Tune() {
  const { studio } = useApp();
  const oak = useTunedOak();
  const catalog = useStore(studio.catalog);
  const rejection = useStore(studio.rejections).get(oak?.key ?? "");
  const filters = useSelected(studio.frames, (frames) => JSON.stringify(frames.get(oak?.key ?? "")?.header.filters ?? []));
  const ran = useMemo(() => JSON.parse(filters) as string[], [filters]);
  if (!oak) return null;
  const { state } = oak;
  const sensor = findSensor(catalog, state);
  const engine = findEngine(catalog, state);
  if (!sensor) return <p class="hint pad">{state.model} has no depth sensor. Choose another model.</p>;
  const problem = (field: string) => (rejection?.field === field ? rejection.error : undefined);
  // What no field below shows is shown with the sensor.
  const hasField = ["filters", "colorImager", "transparent"].includes(rejection?.field ?? "") || rejection?.field?.startsWith("drift.") || engine?.parameters.some(({ name }) => name === rejection?.field);
  return (
    <>
      <SensorSection state={state} sensor={sensor} problem={hasField ? undefined : rejection?.error} />
      <UnitSection state={state} problem={problem} />
      {sensor.kind === "stereo" && <DriftSection state={state} problem={problem} />}
      <ColoursSection state={state} problem={problem} />
      <Section title="Filters" isOpen={state.filters !== null}>
        <FilterList
          filters={catalog.filters}
          value={state.filters}
          ran={ran}
          problem={problem("filters")}
          onChange={(tag, filters) => studio.change(tag, (state) => ({ ...state, filters }))}
        />
      </Section>
      {engine && <Parameters key={engine.name} parameters={engine.parameters} state={state} problem={problem} />}
    </>
  );
}

/** Returns the selected OAK as it was when anything but its pose changed: the controls need not be made anew while it moves. */
function useTunedOak(): Oak | undefined {
  const { studio } = useApp();
  const last = useRef<Oak | undefined>(undefined);
  return useSelected(studio.document, (document) => {
    const next = selectedOak(document);
    const { current } = last;
    if (next && current && next.key === current.key && isTunedAlike(next.state, current.state)) return current;
    last.current = next;
    return next;
  });
}

function isTunedAlike(a: OakState, b: OakState): boolean {
  return Object.keys(a).every((key) => key === "pose" || a[key as keyof OakState] === b[key as keyof OakState]);
}

function SensorSection({ state, sensor, problem }: { state: OakState; sensor: DepthSensor; problem: string | undefined }) {
  const { studio } = useApp();
  const catalog = useStore(studio.catalog);
  const isAmongOthers = useSelected(studio.document, ({ oaks }) => oaks.length > 1);
  const model = findModel(catalog, state.model);
  const engine = findEngine(catalog, state);
  const set = (tag: string, change: Partial<OakState>) => studio.change(tag, (state) => ({ ...state, ...change }));
  return (
    <Section title="Sensor" actions={isAmongOthers && <ForAll />}>
      {(model?.depthSensors.length ?? 0) > 1 && (
        <Select
          label="Depth sensor"
          value={state.sensor}
          options={(model?.depthSensors ?? []).map(({ id }) => ({ value: id, title: words(id) }))}
          onChange={(id) => {
            const next = model?.depthSensors.find((sensor) => sensor.id === id);
            set("sensor", { sensor: id, engine: next?.engines[0] ?? "", preset: null, parameters: {}, filters: null });
          }}
        />
      )}
      <Select
        label="Engine"
        testId="engine"
        value={state.engine}
        options={sensor.engines.map((name) => ({ value: name, title: words(name) }))}
        onChange={(name) => set("engine", { engine: name, parameters: {} })}
      />
      {engine && <p class="hint">{engine.help}</p>}
      {sensor.kind === "stereo" && <Light state={state} isSeen={engine ? seesLight(engine) : false} hasProjector={model?.hasProjector ?? false} />}
      {sensor.presets.length > 0 && (
        <Select
          label="Preset"
          value={state.preset ?? ""}
          options={[{ value: "", title: "None" }, ...sensor.presets.map((name) => ({ value: name, title: words(name) }))]}
          onChange={(preset) => set("preset", { preset: preset || null })}
        />
      )}
      {sensor.kind === "stereo" && (
        <Check
          label="Extended disparity"
          tip="Doubles the disparity range, for near surfaces"
          isOn={state.extendedDisparity}
          onChange={(extendedDisparity) => set("extended", { extendedDisparity })}
        />
      )}
      {sensor.kind === "stereo" && model?.hasFisheye && (
        <Check
          label="Fisheye lenses"
          tip="The optics of the left and right cameras of wide models: fisheye instead of pinhole"
          isOn={state.lens === "fisheye"}
          onChange={(isOn) => set("lens", { lens: isOn ? "fisheye" : "pinhole" })}
        />
      )}
      {problem && <p class="problem" role="alert">{problem}</p>}
    </Section>
  );
}

/** Gives all OAKs what the selected one has. */
function ForAll() {
  const { studio } = useApp();
  return (
    <Menu icon="copy" label="For all" testId="for-all">
      {(close) => SHARED.map(({ name, title }) => (
        <button key={name} type="button" role="menuitem" class="menu-item" onClick={() => { close(); setForAll(studio, name); }}>{title}</button>
      ))}
    </Menu>
  );
}

/** Whether the light determines what an engine measures: in the images of the pair, or by its parameters. */
function seesLight({ isMatcher, parameters }: Engine): boolean {
  return isMatcher || parameters.some(({ name }) => name === "dotContrast");
}

/** The light for the infrared cameras. */
function Light({ state, isSeen, hasProjector }: { state: OakState; isSeen: boolean; hasProjector: boolean }) {
  const { studio } = useApp();
  const isNight = state.ambient === 0;
  return (
    <>
      <div class="row">
        <span class="name" id="light">Light</span>
        <div class="segments" role="group" aria-labelledby="light">
          <Button label="Day" isOn={!isNight} onClick={() => studio.change("ambient", (state) => ({ ...state, ambient: 1 }))} />
          <Button label="Night" isOn={isNight} onClick={() => studio.change("ambient", (state) => ({ ...state, ambient: 0 }))} />
        </div>
      </div>
      <div class="pair">
        <NumberField
          label="Ambient"
          tip="The brightness of the scene's own light in the infrared images; 1 is that of the scene"
          value={state.ambient}
          onChange={(ambient) => studio.change("ambient", (state) => ({ ...state, ambient }))}
          step={0.1}
          digits={3}
          minimum={0}
          maximum={100}
        />
        {(hasProjector || state.projector > 0) && <NumberField
          label="Projector"
          tip="The brightness of the dot projector; 0 is off, 1 its full power"
          value={state.projector}
          onChange={(projector) => studio.change("projector", (state) => ({ ...state, projector }))}
          step={0.1}
          digits={3}
          minimum={0}
          maximum={100}
        />}
      </div>
      {!isSeen && <p class="hint">The light changes the left and right images. This engine does not depend on them.</p>}
    </>
  );
}

function Parameters({ parameters, state, problem }: {
  parameters: Parameter[]; state: OakState; problem: (field: string) => string | undefined;
}) {
  const { studio, defaults } = useApp();
  useStore(defaults);
  const changed = Object.keys(state.parameters).length;
  const set = (name: string, value: string | undefined) => studio.change(`parameter ${name}`, (state) => {
    const { [name]: _, ...others } = state.parameters;
    return { ...state, parameters: value === undefined ? others : { ...others, [name]: value } };
  });
  return (
    <>
      <div class="divider">
        <h2>Parameters</h2>
        {changed > 0 && (
          <Button
            label={`Reset all ${changed}`}
            class="text"
            testId="reset-all"
            onClick={() => studio.change("reset", (state) => ({ ...state, parameters: {} }))}
          />
        )}
      </div>
      {grouped(parameters).map(([group, members]) => (
        <Section key={group} title={words(group)} testId="parameter-group">
          {members.map((parameter) => (
            <ParameterField
              key={parameter.name}
              parameter={parameter}
              value={state.parameters[parameter.name]}
              fallback={defaults.of(state, parameter)}
              problem={problem(parameter.name)}
              onChange={(value) => set(parameter.name, value)}
            />
          ))}
        </Section>
      ))}
    </>
  );
}
