import type { Frames } from "../state/timeline";
import { decimal } from "../util/format";
import { useStore } from "../util/store";
import { useApp } from "./context";
import { Button, Select } from "./controls";

const SPEEDS = [0.25, 0.5, 1, 2, 4].map((speed) => ({ value: String(speed), title: `${speed} ×` }));

/** Plays what moves; absent if nothing does. */
export function TimelineBar() {
  const { studio } = useApp();
  const { timeline } = studio;
  useStore(studio.scene);
  useStore(timeline.trajectories.all);
  const { moment, trajectory } = useStore(studio.document);
  const isPlaying = useStore(timeline.isPlaying);
  const speed = useStore(timeline.speed);
  const frames = timeline.frames();
  if (!frames) return null;
  const frame = Math.min(moment?.frame ?? 0, frames.count - 1);
  const take = (event: Event) => {
    timeline.pause();
    timeline.go(Number((event.currentTarget as HTMLInputElement).value));
  };
  return (
    <div class="timeline" role="group" aria-label="Timeline" data-testid="timeline">
      <Button icon={isPlaying ? "pause" : "play"} label={isPlaying ? "Pause (Space)" : "Play (Space)"} onClick={() => timeline.toggle()} testId="play" />
      <input
        type="range"
        min={0}
        max={frames.count - 1}
        step={1}
        value={frame}
        aria-label="Frame"
        aria-valuetext={text(frames, frame)}
        data-testid="frame"
        onInput={take}
      />
      <output data-testid="moment">{moment ? text(frames, frame) : `As opened; ${frames.count.toLocaleString("en")} frames`}</output>
      <Select label="Speed" isLabelled={false} value={String(speed)} options={SPEEDS} onChange={(value) => timeline.speed.set(Number(value))} testId="speed" />
      {moment && <Button icon="close" label={trajectory ? "Leave the trajectory" : "Show the scene as it was opened"} onClick={() => timeline.leave()} testId="leave-timeline" />}
    </div>
  );
}

function text({ count, codes, timeOf }: Frames, frame: number): string {
  const code = codes ? `, time code ${decimal(codes.first + frame * codes.step, 2)}` : "";
  return `${decimal(timeOf(frame), 2)} s, frame ${frame.toLocaleString("en")} of ${(count - 1).toLocaleString("en")}${code}`;
}
