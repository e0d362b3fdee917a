import type { Vec3 } from "../protocol";
import { selectedOak } from "../state/document";
import { type Angles, fromAngles, toAngles } from "../util/pose";
import { useStore } from "../util/store";
import { Button, NumberField, Section } from "./controls";
import { useApp } from "./context";

const AXES = ["X", "Y", "Z"] as const;
const ANGLES: { key: keyof Angles; label: string; tip: string }[] = [
  { key: "yaw", label: "Yaw", tip: "The turn about the vertical axis; positive to the left" },
  { key: "pitch", label: "Tilt", tip: "The tilt of the optical axis; positive looks down" },
  { key: "roll", label: "Roll", tip: "The turn about the optical axis; positive to the right" },
];

/** The pose of the selected OAK in numbers. */
export function PoseFields() {
  const { studio, view } = useApp();
  const scene = useStore(studio.scene);
  const oak = selectedOak(useStore(studio.document));
  if (!oak) return null;
  const up = scene?.up ?? "z";
  const { pose } = oak.state;
  const angles = toAngles(pose.quaternion, up);
  const move = (axis: number, value: number) => studio.change(`position${axis}`, (state) => {
    const position: Vec3 = [...state.pose.position];
    position[axis] = value;
    return { ...state, pose: { ...state.pose, position } };
  });
  const turn = (key: keyof Angles, value: number) => studio.change(key, (state) => ({
    ...state,
    pose: { ...state.pose, quaternion: fromAngles({ ...toAngles(state.pose.quaternion, up), [key]: value }, up) },
  }));
  const reset = () => scene && studio.change("pose", (state) => ({ ...state, pose: scene.pose }));
  return (
    <Section
      title="Pose"
      actions={
        <>
          <Button icon="camera" label="Look from the OAK" onClick={() => view.get()?.lookThrough()} />
          <Button icon="reset" label="Put it where it was at first" onClick={reset} />
        </>
      }
    >
      <div class="triple">
        {AXES.map((label, axis) => (
          <NumberField
            key={label}
            label={label}
            value={pose.position[axis] ?? 0}
            onChange={(value) => move(axis, value)}
            step={0.05}
            digits={3}
            unit="m"
            testId={`position-${label.toLowerCase()}`}
          />
        ))}
        {ANGLES.map(({ key, label, tip }) => (
          <NumberField
            key={key}
            label={label}
            tip={tip}
            value={angles[key]}
            onChange={(value) => turn(key, value)}
            step={1}
            digits={2}
            minimum={key === "pitch" ? -90 : -360}
            maximum={key === "pitch" ? 90 : 360}
            unit="°"
          />
        ))}
      </div>
    </Section>
  );
}
