import { css, oakColor } from "../gpu/colormaps";
import {
  addOak, changeOak, defaultState, findModel, findSensor, MAX_OAKS, type Oak, removeOak, selectedOak, withModel,
} from "../state/document";
import type { Model } from "../protocol";
import { useStore } from "../util/store";
import { Button, Check, Section } from "./controls";
import { useApp } from "./context";

/** The list of OAKs: add, duplicate, hide, remove, select, and the model of each. */
export function OakList() {
  const { studio } = useApp();
  const document = useStore(studio.document);
  const { oaks } = document;
  const isFull = oaks.length >= MAX_OAKS;
  const duplicate = () => {
    const oak = selectedOak(document);
    if (oak) studio.document.commit("add", (document) => addOak(document, structuredClone(oak.state)));
  };
  return (
    <Section
      title="OAKs"
      actions={
        <>
          <AddOak isDisabled={isFull} />
          <Button icon="copy" label="Duplicate the selected OAK" onClick={duplicate} isDisabled={isFull} testId="duplicate" />
        </>
      }
    >
      <ul class="oaks" data-testid="oaks">
        {oaks.map((oak, index) => <OakRow key={oak.key} oak={oak} index={index} isLast={oaks.length === 1} />)}
      </ul>
      {oaks.length > 1 && (
        <Check
          label="Same pose for all"
          tip="Moving one OAK moves all, to compare models at the same place"
          isOn={document.arePosesLinked}
          onChange={(arePosesLinked) => studio.document.commit("link poses", (document) => ({ ...document, arePosesLinked }))}
        />
      )}
    </Section>
  );
}

/** The models by maker; those without a depth sensor cannot be chosen. */
function ModelOptions({ models, selected }: { models: Model[]; selected?: string }) {
  const makers = [...new Set(models.map((model) => model.maker))];
  return makers.map((maker) => (
    <optgroup key={maker} label={maker}>
      {models.filter((model) => model.maker === maker).map(({ name, depthSensors }) => {
        const hasDepth = depthSensors.length > 0;
        return (
          <option key={name} value={name} selected={name === selected} disabled={!hasDepth}>
            {hasDepth ? name : `${name} (no depth)`}
          </option>
        );
      })}
    </optgroup>
  ));
}

/** Adds another model at the pose of the selected OAK. */
function AddOak({ isDisabled }: { isDisabled: boolean }) {
  const { studio } = useApp();
  const { models } = useStore(studio.catalog);
  const add = (name: string) => {
    const catalog = studio.catalog.get();
    const model = findModel(catalog, name);
    const oak = selectedOak(studio.document.get());
    if (!model || !oak) return;
    studio.document.commit("add", (document) => addOak(document, defaultState(model, oak.state.pose)));
  };
  return (
    <select
      class="add"
      aria-label="Add an OAK at the same pose"
      data-tip="Add an OAK at the same pose, to compare models"
      data-testid="add-oak"
      disabled={isDisabled}
      value=""
      onKeyDown={(event) => {
        // A closed list would choose the first entry, which adds an OAK.
        const opens = event.key === "ArrowDown" || event.key === "ArrowUp" || (event.key.length === 1 && !event.ctrlKey && !event.metaKey);
        if (!opens) return;
        event.preventDefault();
        event.currentTarget.showPicker?.();
      }}
      onChange={(event) => {
        add(event.currentTarget.value);
        event.currentTarget.value = "";
      }}
    >
      <option value="">Add…</option>
      <ModelOptions models={models} />
    </select>
  );
}

function OakRow({ oak, index, isLast }: { oak: Oak; index: number; isLast: boolean }) {
  const { studio } = useApp();
  const catalog = useStore(studio.catalog);
  const { selected } = useStore(studio.document);
  const rejection = useStore(studio.rejections).get(oak.key);
  const isSelected = selected === oak.key;
  const select = () => studio.document.set({ ...studio.document.get(), selected: oak.key });
  const setModel = (name: string) => {
    const model = findModel(catalog, name);
    if (model) studio.document.commit("model", (document) => changeOak({ ...document, selected: oak.key }, oak.key, (state) => withModel(state, model)));
  };
  const hide = () => studio.document.commit("hide", (document) => ({
    ...document,
    oaks: document.oaks.map((other) => (other.key === oak.key ? { ...other, isHidden: !other.isHidden } : other)),
  }));
  return (
    <li class={`oak ${isSelected ? "selected" : ""}`}>
      <button type="button" class="dot" aria-label={`Select OAK ${index + 1}, ${oak.state.model}`} aria-pressed={isSelected} onClick={select}>
        <span style={{ background: css(oakColor(index)) }} />
      </button>
      <div class="oak-main" onClick={select}>
        <select
          aria-label={`Model of OAK ${index + 1}`}
          data-testid="model"
          value={oak.state.model}
          onChange={(event) => setModel(event.currentTarget.value)}
        >
          <ModelOptions models={catalog.models} selected={oak.state.model} />
        </select>
      </div>
      <Button icon={oak.isHidden ? "hidden" : "eye"} label={oak.isHidden ? "Show" : "Hide"} isOn={oak.isHidden} onClick={hide} />
      <Button
        icon="close"
        label="Remove"
        isDisabled={isLast}
        onClick={() => studio.document.commit("remove", (document) => removeOak(document, oak.key))}
      />
      <div class="oak-about" onClick={select}>
        <span class="detail">{describe(oak, catalog)}</span>
        {rejection && !isSelected && <span class="problem" role="alert">{rejection.error}</span>}
      </div>
    </li>
  );
}

function describe(oak: Oak, catalog: Parameters<typeof findSensor>[0]): string {
  const model = findModel(catalog, oak.state.model);
  const sensor = findSensor(catalog, oak.state);
  if (!model) return "The server does not know this model.";
  if (!sensor) return `${model.generation} · no depth sensor`;
  const kind = sensor.kind === "tof" ? "ToF" : sensor.baselineM ? `${(sensor.baselineM * 1000).toFixed(0)} mm` : "stereo";
  return `${kind} · ${sensor.hfovDeg.toFixed(0)}° · ${oak.state.engine}`;
}
