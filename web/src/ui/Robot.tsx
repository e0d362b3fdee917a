import type { RobotJoint } from "../protocol";
import { selectedOak } from "../state/document";
import { useStore } from "../util/store";
import { Button, NumberField, Section, Select } from "./controls";
import { useApp } from "./context";

const DEGREE = Math.PI / 180;

/** The slider of a joint without limits: a turn to each side, or a metre. */
const FREE = { turn: 180, way: 1 };

/** The joints of the robot in the scene, and the link that carries the selected OAK. */
export function Robot() {
  const { studio } = useApp();
  const robot = useStore(studio.scene)?.robot;
  const oak = selectedOak(useStore(studio.document));
  if (!robot || !oak) return null;
  const mounts = [{ value: "", title: "None: it stays in the room" }, ...robot.links.map(({ name }) => ({ value: name, title: name }))];
  const mount = oak.mount ?? "";
  return (
    <Section
      title="Robot"
      testId="robot"
      actions={<Button icon="reset" label="Put the joints where they were at first" onClick={() => studio.robot.rest()} />}
    >
      <Select label="Carries the OAK" value={mount} options={mounts} testId="mount" onChange={(link) => studio.robot.mount(oak.key, link || null)} />
      {mount !== "" && <Button label="Put the OAK there" tip="At the origin of the link, looking along its x axis" onClick={() => studio.robot.toLink()} testId="to-link" />}
      {robot.joints.map((joint, index) => <Joint key={joint.name} joint={joint} onMove={(position) => studio.robot.move(index, position)} />)}
      {robot.joints.length === 0 && <p class="hint">It has no joints that move.</p>}
    </Section>
  );
}

function Joint({ joint, onMove }: { joint: RobotJoint; onMove: (position: number) => void }) {
  const factor = joint.isRevolute ? DEGREE : 1;
  const free = joint.isRevolute ? FREE.turn : FREE.way;
  const [low, high] = joint.limits ? joint.limits.map((limit) => limit / factor) as [number, number] : [-free, free];
  const value = joint.position / factor;
  const [step, digits, unit] = joint.isRevolute ? [1, 2, "°"] : [0.005, 4, "m"];
  // Degrees that were rounded must not be beyond limits in radians.
  const move = (next: number) => onMove(Math.min(Math.max(next * factor, joint.limits?.[0] ?? -Infinity), joint.limits?.[1] ?? Infinity));
  return (
    <div class="joint">
      <NumberField label={joint.name} value={value} onChange={move} step={step} digits={digits} unit={unit} testId={`joint-${joint.name}`} {...(joint.limits && { minimum: Number(low.toFixed(digits)), maximum: Number(high.toFixed(digits)) })} />
      <input
        type="range"
        aria-label={joint.name}
        min={low}
        max={high}
        step={(high - low) / 500 || 1}
        value={value}
        data-testid={`slide-${joint.name}`}
        onInput={(event) => move(Number(event.currentTarget.value))}
      />
    </div>
  );
}
