import type { Filter } from "../protocol";
import { type FilterUse, formatFilter, parseFilter } from "../state/filters";
import { words } from "../util/format";
import { Button } from "./controls";
import { ParameterField } from "./ParameterField";

interface Props {
  filters: Filter[];
  /** What is set; null for the preset's filters. */
  value: string[] | null;
  /** The filters that ran in the last frame. */
  ran: string[];
  problem: string | undefined;
  onChange: (tag: string, value: string[] | null) => void;
}

/** The chain of filters, which run from top to bottom. */
export function FilterList({ filters, value, ran, problem, onChange }: Props) {
  const uses = (value ?? ran).map(parseFilter);
  const put = (tag: string, next: FilterUse[]) => onChange(tag, next.map(formatFilter));
  const move = (index: number, by: number) => {
    const moved = uses[index];
    if (moved) put("order", uses.toSpliced(index, 1).toSpliced(index + by, 0, moved));
  };
  return (
    <div class="filters">
      <ol>
        {uses.map((use, index) => (
          <li key={`${use.name}${index}`} class="filter">
            <div class="parameter-head">
              <span class="name">{words(use.name)}</span>
              <Button icon="up" label={`Move ${use.name} up`} class="small" isDisabled={index === 0} onClick={() => move(index, -1)} />
              <Button icon="down" label={`Move ${use.name} down`} class="small" isDisabled={index === uses.length - 1} onClick={() => move(index, 1)} />
              <Button icon="close" label={`Remove ${use.name}`} class="small" onClick={() => put("remove filter", uses.toSpliced(index, 1))} />
            </div>
            <FilterParameters
              use={use}
              filter={filters.find(({ name }) => name === use.name)}
              onChange={(changed) => put(`filter ${index} ${use.name}`, uses.with(index, changed))}
            />
          </li>
        ))}
      </ol>
      {uses.length === 0 && <p class="hint">No filter runs.</p>}
      {problem && <p class="problem" role="alert">{problem}</p>}
      <div class="row">
        <select
          aria-label="Add a filter"
          value=""
          data-testid="add-filter"
          onChange={(event) => {
            put("add filter", [...uses, { name: event.currentTarget.value, parameters: {} }]);
            event.currentTarget.value = "";
          }}
        >
          <option value="">Add a filter…</option>
          {filters.map(({ name }) => <option key={name} value={name}>{words(name)}</option>)}
        </select>
        {value !== null && <Button icon="reset" label="Use the preset's filters" onClick={() => onChange("filters", null)} />}
      </div>
    </div>
  );
}

function FilterParameters({ use, filter, onChange }: { use: FilterUse; filter: Filter | undefined; onChange: (use: FilterUse) => void }) {
  if (!filter) return null;
  const set = (name: string, value: string | undefined) => {
    const { [name]: _, ...others } = use.parameters;
    onChange({ ...use, parameters: value === undefined ? others : { ...others, [name]: value } });
  };
  return (
    <div class="filter-parameters">
      {filter.parameters.map((parameter) => (
        <ParameterField
          key={parameter.name}
          parameter={parameter}
          value={use.parameters[parameter.name]}
          fallback={parameter.default}
          problem={undefined}
          onChange={(value) => set(parameter.name, value)}
        />
      ))}
    </div>
  );
}
