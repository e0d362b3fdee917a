import { type Reflectances, reflectances, reflecting } from "../state/infrared";
import { useStore } from "../util/store";
import { Button, NumberField } from "./controls";
import { useApp } from "./context";

/** The reflectance of a surface that was just added. */
const FIRST = 0.5;

/** How much infrared light surfaces of the scene reflect, which belongs to the scene: all OAKs see it. */
export function Infrared() {
  const { studio } = useApp();
  const { scene } = useStore(studio.document);
  const offered = useStore(studio.scene)?.infrared ?? [];
  const all = reflectances(scene);
  const put = (tag: string, next: Reflectances) =>
    studio.document.commit(tag, (document) => ({ ...document, scene: reflecting(document.scene, next) }));
  const free = offered.filter((name) => all.every(([known]) => known !== name));
  if (offered.length === 0) return null;
  return (
    <div class="infrared" role="group" aria-label="Infrared" data-testid="infrared">
      <span class="name" data-tip="The reflectance at 940 nm of materials and labels of the scene, for all OAKs. The stereo pair, its dots and time of flight see it; colours do not. By default it follows from the colours.">Infrared</span>
      {all.map(([name, value], i) => (
        <div class="row end" key={name}>
          <NumberField
            label={name}
            tip="The reflectance at 940 nm: 0 is black, 1 is white"
            value={value}
            onChange={(next) => put(`infrared ${name}`, all.with(i, [name, next]))}
            step={0.05}
            digits={3}
            minimum={0}
            maximum={1}
            testId={`infrared-${name}`}
          />
          <Button icon="close" label={`Remove the reflectance of ${name}`} class="small" onClick={() => put("remove reflectance", all.toSpliced(i, 1))} />
        </div>
      ))}
      {free.length > 0 && (
        <select
          aria-label="Set the reflectance of"
          value=""
          data-testid="add-infrared"
          onChange={(event) => {
            put("add reflectance", [...all, [event.currentTarget.value, FIRST]]);
            event.currentTarget.value = "";
          }}
        >
          <option value="">Set a reflectance…</option>
          {free.map((name) => <option key={name} value={name}>{name}</option>)}
        </select>
      )}
    </div>
  );
}
