import type { ComponentChildren } from "preact";
import { useEffect, useRef, useState } from "preact/hooks";
import { decimal, typed } from "../util/format";
import { Icon, type IconName } from "./icons";

interface ButtonProps {
  icon?: IconName;
  label: string;
  onClick: () => void;
  /** Whether the label is shown beside the icon; otherwise it is the tooltip. */
  isNamed?: boolean;
  isOn?: boolean;
  isDisabled?: boolean;
  class?: string;
  tip?: string;
  testId?: string;
}

export function Button({ icon, label, onClick, isNamed = !icon, isOn, isDisabled = false, class: kind = "", tip, testId }: ButtonProps) {
  return (
    <button
      type="button"
      class={`button ${isNamed ? "" : "square"} ${kind}`}
      aria-label={isNamed ? undefined : label}
      aria-pressed={isOn}
      disabled={isDisabled}
      data-tip={tip ?? (isNamed ? undefined : label)}
      data-testid={testId}
      onClick={onClick}
    >
      {icon && <Icon name={icon} />}
      {isNamed && <span>{label}</span>}
    </button>
  );
}

interface SelectProps<T extends string> {
  label: string;
  value: T;
  options: readonly { value: T; title: string }[];
  onChange: (value: T) => void;
  isLabelled?: boolean;
  testId?: string;
}

export function Select<T extends string>({ label, value, options, onChange, isLabelled = true, testId }: SelectProps<T>) {
  return (
    <label class="field">
      <span class={isLabelled ? "name" : "sr-only"}>{label}</span>
      <select value={value} data-testid={testId} onChange={(event) => onChange(event.currentTarget.value as T)}>
        {options.map((option) => (
          <option key={option.value} value={option.value} selected={option.value === value}>{option.title}</option>
        ))}
      </select>
    </label>
  );
}

export function Check({ label, isOn, onChange, tip, isDisabled = false }: {
  label: string; isOn: boolean; onChange: (isOn: boolean) => void; tip?: string; isDisabled?: boolean;
}) {
  return (
    <label class="check" data-tip={tip}>
      <input type="checkbox" checked={isOn} disabled={isDisabled} onChange={(event) => onChange(event.currentTarget.checked)} />
      <span>{label}</span>
    </label>
  );
}

interface TextFieldProps {
  label: string;
  /** The text of the value; typed text replaces it while the field has the focus. */
  text: string;
  /** Takes what was typed; returns a problem for the field, or null. */
  onText: (text: string) => string | null;
  /** Called for the arrow keys with 1 or -1; a tenth with Shift. */
  onStep?: (direction: number) => void;
  /** A problem that the server found. */
  problem?: string | undefined;
  isLabelled?: boolean;
  tip?: string;
  unit?: string | null;
  testId?: string;
}

/** A field that changes the value while somebody types, as long as the text is valid. */
export function TextField({ label, text, onText, onStep, problem, isLabelled = true, tip, unit, testId }: TextFieldProps) {
  const [draft, setDraft] = useState<string | null>(null);
  const [own, setOwn] = useState<string | null>(null);
  const input = useRef<HTMLInputElement>(null);
  const shown = own ?? problem;
  // A value that changes from elsewhere, such as by undo, replaces the typed text.
  useEffect(() => {
    if (document.activeElement !== input.current) {
      setDraft(null);
      setOwn(null);
    }
  }, [text]);
  const leave = () => {
    setDraft(null);
    setOwn(null);
  };
  const key = (event: KeyboardEvent) => {
    if (event.key === "Enter") leave();
    if (!onStep || (event.key !== "ArrowUp" && event.key !== "ArrowDown")) return;
    event.preventDefault();
    leave();
    onStep((event.key === "ArrowUp" ? 1 : -1) * (event.shiftKey ? 0.1 : 1));
  };
  return (
    <label class="field" data-tip={tip}>
      <span class={isLabelled ? "name" : "sr-only"}>{label}</span>
      <span class="with-unit">
        <input
          ref={input}
          type="text"
          inputMode={onStep ? "decimal" : "text"}
          spellcheck={false}
          autocomplete="off"
          value={draft ?? text}
          aria-invalid={shown ? "true" : undefined}
          data-testid={testId}
          onInput={(event) => {
            setDraft(event.currentTarget.value);
            setOwn(onText(event.currentTarget.value));
          }}
          onBlur={leave}
          onKeyDown={key}
        />
        {unit && <span class="unit">{unit}</span>}
      </span>
      {shown && <span class="problem" role="alert">{shown}</span>}
    </label>
  );
}

interface NumberFieldProps {
  label: string;
  value: number;
  onChange: (value: number) => void;
  step: number;
  digits: number;
  minimum?: number;
  maximum?: number;
  unit?: string;
  isLabelled?: boolean;
  tip?: string;
  problem?: string | undefined;
  testId?: string;
}

export function NumberField({ value, onChange, step, digits, minimum = -1e6, maximum = 1e6, ...rest }: NumberFieldProps) {
  const take = (text: string): string | null => {
    const value = Number(typed(text));
    if (text.trim() === "" || !Number.isFinite(value)) return "Enter a number.";
    if (value < minimum) return `Enter at least ${decimal(minimum, 9)}.`;
    if (value > maximum) return `Enter at most ${decimal(maximum, 9)}.`;
    onChange(value);
    return null;
  };
  const nudge = (direction: number) => {
    const next = Number((value + direction * step).toFixed(digits + 1));
    onChange(Math.min(maximum, Math.max(minimum, next)));
  };
  return <TextField {...rest} text={decimal(value, digits)} onText={take} onStep={nudge} />;
}

/** A part of a side bar that can be folded. */
export function Section({ title, children, actions, isOpen = true, testId }: {
  title: string; children: ComponentChildren; actions?: ComponentChildren; isOpen?: boolean; testId?: string;
}) {
  const [open, setOpen] = useState(isOpen);
  return (
    <section class="section" data-testid={testId}>
      <div class="section-head">
        <h2>
          <button type="button" class="fold" aria-expanded={open} onClick={() => setOpen(!open)}>{title}</button>
        </h2>
        {actions && <div class="actions">{actions}</div>}
      </div>
      {open && <div class="section-body">{children}</div>}
    </section>
  );
}
