import { useRef, useState } from "preact/hooks";
import type { MotionAnswer, MotionInfo, RobotInfo } from "../protocol";
import { selectedOak, type Target } from "../state/document";
import { openFiles } from "../studio/files";
import { api } from "../net/api";
import { save } from "../util/away";
import { bareMillimetres, bareShare, decimal, NONE, share } from "../util/format";
import { useStore } from "../util/store";
import { Heading } from "./ColumnName";
import { Button, Section } from "./controls";
import { useApp } from "./context";
import { TextDialog } from "./TextDialog";

const DEGREE = Math.PI / 180;

/** Over a list of postures of the robot: what the selected OAK measures of the region, and where the robot is in its own way. */
export function Motion({ target, tolerance }: { target: Target | null; tolerance: number | null }) {
  const { studio } = useApp();
  const { motion } = studio;
  const document = useStore(studio.document);
  const robot = useStore(studio.scene)?.robot;
  useStore(motion.lists.all);
  const progress = useStore(motion.progress);
  const measured = useStore(motion.measured);
  const problem = useStore(motion.problem);
  const [command, setCommand] = useState<string | null>(null);
  const input = useRef<HTMLInputElement>(null);
  const oak = selectedOak(document);
  if (!robot || !oak) return null;
  const list = motion.lists.current();
  const request = target && motion.request(target, tolerance);
  // Numbers that were measured for something else are not shown.
  const answer = request && measured?.key === motion.key(request) ? measured.answer : null;
  const canMeasure = target !== null && studio.hasDepth(oak.state);
  const showCommand = () => {
    if (request) api.motionCommand(request).then(async ({ file }) => setCommand(await file.text()), (error) => studio.report("The command", error));
  };
  return (
    <Section title="Motion" testId="motion" actions={list && <Button icon="close" label="Remove the list" onClick={() => motion.clear()} />}>
      <p class="hint">{list ? `What the selected OAK${oak.mount ? `, on the link ${oak.mount},` : ""} sees over these postures. A click on one moves the robot.` : "What will the camera see over a motion, and where is the robot in its own way? Collect postures with the joints' sliders, or open a table of them."}</p>
      <div class="row">
        <Button label="Add this posture" tip="The posture in which the robot is now" onClick={() => motion.add()} testId="add-posture" />
        <Button label="Open a list…" tip="A CSV file: names of joints in the first line, then a line for each posture, in radians and metres, or degrees in columns such as elbow_deg" onClick={() => input.current?.click()} />
        <input
          ref={input}
          type="file"
          accept=".csv"
          hidden
          data-testid="motion-file"
          onChange={(event) => {
            void openFiles(studio, [...(event.currentTarget.files ?? [])]);
            event.currentTarget.value = "";
          }}
        />
      </div>
      {list && !target && <p class="hint">Choose a region above to measure it.</p>}
      {list && target && !canMeasure && <p class="hint">This model has no depth sensor.</p>}
      {list && canMeasure && (
        <div class="row">
          {progress
            ? <Button label="Cancel" onClick={() => motion.cancel()} testId="cancel-motion" />
            : <Button label={list.postures.length === 1 ? "Measure 1 posture" : `Measure ${list.postures.length} postures`} class="primary" onClick={() => void motion.measure(target, tolerance)} testId="run-motion" />}
          {progress && <span class="hint" role="status">{`${progress[0]} of ${progress[1]}`}</span>}
        </div>
      )}
      {problem && <p class="problem" role="alert">{problem}</p>}
      {list && <Postures robot={robot} list={list} answer={answer} />}
      {list && (
        <div class="row">
          {answer && <Button label="Table (CSV)" tip="coverage.csv, as the command writes it" onClick={() => save("coverage.csv", new Blob([answer.csv], { type: "text/csv" }))} testId="motion-csv" />}
          {request && <Button label="Command…" tip="The command that measures the same" onClick={showCommand} testId="motion-command" />}
          <Button label="Postures (CSV)" tip="The list, as --joints reads it" onClick={() => save(list.name, motion.file())} />
        </div>
      )}
      {command !== null && <TextDialog title="Command line" text={command} onClose={() => setCommand(null)} />}
    </Section>
  );
}

function Postures({ robot, list, answer }: { robot: RobotInfo; list: MotionInfo; answer: MotionAnswer | null }) {
  const { motion } = useApp().studio;
  const isNow = (posture: number[]) => posture.every((position, i) => Math.abs(position - (robot.joints[i]?.position ?? 0)) < 1e-6);
  return (
    <div class="scroll-x postures">
      <table class="numbers ranking narrow" data-testid="postures">
        <thead>
          <tr>
            <th scope="col">No.</th>
            <Heading name="Visible, %" tip="The share of the surface that the camera sees" />
            <Heading name="Measured, %" tip="The share of the surface that is measured" />
            <Heading name="Robot hides, %" tip="The share of the surface that the robot hides from its camera" />
            <Heading name="|Error|, mm" tip="The median of the absolute errors" />
            <td />
          </tr>
        </thead>
        <tbody>
          {answer && list.postures.length > 1 && (
            <tr class="together" data-testid="posture-all">
              <td data-tip="A point counts if it is measured in one of the postures">All</td>
              <td>{bareShare(answer.together.seen)}</td>
              <td><b>{bareShare(answer.together.measured)}</b></td>
              <td>{NONE}</td>
              <td>{bareMillimetres(answer.together.medianAbsoluteErrorM)}</td>
              <td />
            </tr>
          )}
          {list.postures.map((posture, i) => {
            const own = answer?.postures[i];
            return (
              <tr key={i} aria-current={isNow(posture) ? "true" : undefined} data-testid={`posture-${i}`}>
                <td><Button label={String(i)} class="text" tip={described(robot, posture)} onClick={() => motion.show(i)} /></td>
                <td>{bareShare(own?.seen)}</td>
                <td><b>{bareShare(own?.measured)}</b></td>
                <td data-tip={own && inView(own.links)}>{bareShare(own?.hiddenByRobot)}</td>
                <td>{bareMillimetres(own?.medianAbsoluteErrorM)}</td>
                <td><Button icon="close" label={`Remove posture ${i}`} class="text" onClick={() => motion.remove(i)} /></td>
              </tr>
            );
          })}
        </tbody>
      </table>
    </div>
  );
}

/** The positions of the joints in words. */
function described(robot: RobotInfo, posture: number[]): string {
  const joint = ({ name, isRevolute }: RobotInfo["joints"][number], i: number) =>
    `${name} ${isRevolute ? `${decimal((posture[i] ?? 0) / DEGREE, 1)}°` : `${decimal(posture[i] ?? 0, 3)} m`}`;
  return `Move the robot there: ${robot.joints.map(joint).join(", ")}`;
}

function inView(links: readonly [string, number][]): string {
  const named = links.slice(0, 3).map(([name, own]) => `${name} ${share(own)}`);
  return named.length ? `In the image: ${named.join(", ")} of the pixels` : "The robot is not in the image";
}
