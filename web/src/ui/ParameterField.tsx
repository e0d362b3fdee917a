import type { Parameter } from "../protocol";
import { check, range, slider } from "../state/parameters";
import { minus, words } from "../util/format";
import { Button, TextField } from "./controls";

interface Props {
  parameter: Parameter;
  /** The value that was set; undefined for the default. */
  value: string | undefined;
  /** The effective default. */
  fallback: string;
  /** What the server rejected about it. */
  problem: string | undefined;
  onChange: (value: string | undefined) => void;
  /** The share of the range that the slider covers. */
  reach?: number;
}

/** One parameter: a slider or a choice, a field, its unit, and a mark if it was changed or its default is an estimate. */
export function ParameterField({ parameter, value, fallback, problem, onChange, reach = 1 }: Props) {
  const { name, isEstimate } = parameter;
  const shown = value ?? brief(fallback);
  const isChanged = value !== undefined && value !== fallback;
  const set = (text: string): string | null => {
    const checked = check(parameter, text);
    if ("problem" in checked) return checked.problem;
    onChange(checked.text === fallback ? undefined : checked.text);
    return null;
  };
  return (
    <div class={`parameter ${isChanged ? "changed" : ""}`} data-parameter={name} data-tip={describe(parameter, fallback)}>
      <div class="parameter-head">
        <span class="name">{words(name)}</span>
        {isEstimate && <span class="badge" data-tip="The default is an estimate: no source gives it">estimate</span>}
        {isChanged && <Button icon="reset" label={`Reset ${words(name)} to ${fallback}`} class="small" onClick={() => onChange(undefined)} />}
      </div>
      <Control parameter={parameter} shown={shown} fallback={fallback} problem={problem} reach={reach} onText={set} />
    </div>
  );
}

function Control({ parameter, shown, fallback, problem, reach, onText }: {
  parameter: Parameter; shown: string; fallback: string; problem: string | undefined; reach: number; onText: (text: string) => string | null;
}) {
  const label = words(parameter.name);
  if (parameter.type === "boolean") {
    return (
      <label class="switch">
        <input type="checkbox" role="switch" aria-label={label} checked={shown === "true"} onChange={(event) => onText(String(event.currentTarget.checked))} />
        <span>{shown === "true" ? "on" : "off"}</span>
        {problem && <span class="problem" role="alert">{problem}</span>}
      </label>
    );
  }
  if (parameter.choices) {
    return (
      <label class="field">
        <span class="sr-only">{label}</span>
        <select value={shown} onChange={(event) => onText(event.currentTarget.value)}>
          {parameter.choices.map((choice) => <option key={choice} value={choice} selected={choice === shown}>{choice}</option>)}
        </select>
        {problem && <span class="problem" role="alert">{problem}</span>}
      </label>
    );
  }
  const limits = slider(parameter, Number(fallback), reach);
  const step = limits?.step ?? (parameter.type === "integer" ? 1 : 0.01);
  const nudge = (direction: number) => {
    const by = parameter.type === "integer" ? Math.sign(direction) * step : direction * step;
    onText(String(Number((Number(shown) + by).toPrecision(9))));
  };
  return (
    <div class="slide">
      {limits && (
        <input
          type="range"
          aria-label={label}
          min={limits.from}
          max={limits.to}
          step={limits.step}
          value={shown}
          onInput={(event) => onText(event.currentTarget.value)}
        />
      )}
      {parameter.type === "string" ? (
        <TextField label={label} isLabelled={false} text={shown} onText={onText} unit={parameter.unit} problem={problem} />
      ) : (
        <TextField label={label} isLabelled={false} text={minus(shown)} onText={onText} onStep={nudge} unit={parameter.unit} problem={problem} />
      )}
    </div>
  );
}

/** Shortens a default that was computed, such as the focal length of a model. */
function brief(text: string): string {
  const value = Number(text);
  return text.length > 8 && Number.isFinite(value) ? String(Number(value.toPrecision(6))) : text;
}

function describe(parameter: Parameter, fallback: string): string {
  const unit = parameter.unit ? ` ${parameter.unit}` : "";
  const isFree = parameter.type === "string" && !parameter.choices;
  return [
    `${parameter.name}: ${parameter.documentation}`,
    ...(isFree ? [] : [`Range: ${range(parameter)}`]),
    `Default: ${Number.isFinite(Number(fallback)) ? minus(fallback) : fallback}${unit}`,
    `Source: ${parameter.isEstimate ? "estimate" : parameter.source}`,
  ].join("\n");
}
