import { useState } from "preact/hooks";
import { guessUnits, reasonFor, sides, UNITS, type Units } from "../state/units";
import { type Asked, useDropped } from "../studio/files";
import { length } from "../util/format";
import { useStore } from "../util/store";
import { Button, NumberField, Select } from "./controls";
import { useApp } from "./context";
import { Dialog } from "./Dialog";

/** Asks in which unit a mesh file is, and which axis is up. */
export function UnitsDialog() {
  const { studio } = useApp();
  const asked = useStore(studio.asked);
  return asked[0] ? <Question key={asked[0].info.id} asked={asked[0]} /> : null;
}

function Question({ asked }: { asked: Asked }) {
  const { studio } = useApp();
  const { info } = asked;
  const [units, setUnits] = useState<Units>(() => guessUnits(info));
  const [isOther, setOther] = useState(false);
  const done = () => studio.asked.update((all) => all.filter((one) => one !== asked));
  const use = () => {
    done();
    void useDropped(studio, asked, units);
  };
  const options = [...UNITS.map(({ scale, title }) => ({ value: String(scale), title })), { value: "other", title: "another unit" }];
  const [x, y, z] = sides(info.bounds).map((side) => length(side * units.scale));
  return (
    <Dialog title={`Units of ${info.name}`} onClose={done} isNarrow>
      <form class="units" onSubmit={(event) => { event.preventDefault(); use(); }}>
        <p>{`This kind of file does not say in which unit it is. ${reasonFor(guessUnits(info), info)}`}</p>
        <div class="pair">
          <Select
            label="Unit of the file"
            value={isOther ? "other" : String(units.scale)}
            options={options}
            onChange={(value) => {
              setOther(value === "other");
              if (value !== "other") setUnits({ ...units, scale: Number(value) });
            }}
            testId="unit"
          />
          <Select
            label="Up"
            value={units.up}
            options={[{ value: "y" as const, title: "the y axis" }, { value: "z" as const, title: "the z axis" }]}
            onChange={(up) => setUnits({ ...units, up })}
            testId="up"
          />
        </div>
        {isOther && <NumberField label="Metres per unit" value={units.scale} minimum={1e-9} maximum={1e6} step={0.001} digits={9} onChange={(scale) => setUnits({ ...units, scale })} />}
        <p class="size" data-testid="scene-size">{`${x} × ${y} × ${z} along x, y and z`}</p>
        <div class="row spread">
          <Button label="Cancel" onClick={done} />
          <button type="submit" class="button primary" autofocus data-testid="use-scene">Open</button>
        </div>
      </form>
    </Dialog>
  );
}
