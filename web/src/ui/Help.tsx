import { Dialog } from "./Dialog";

const KEYS: [string, [string, string][]][] = [
  ["Everywhere", [
    ["Ctrl+Z, Ctrl+Shift+Z", "Undo, redo"],
    ["1, 2", "Show or hide the controls, the numbers"],
    ["G, R", "Handles that move, turn the OAK"],
    ["P", "Points: none, true, measured, both"],
    ["Home", "Look at the OAK"],
    ["C", "Look from the OAK"],
    ["M", "Measure between two points of the scene"],
    ["F", "Fly the OAK: it moves with the view"],
    ["Space", "Play or pause the timeline"],
    [", and .", "The previous, the next frame of the timeline"],
    ["[, ]", "Select the previous, next OAK"],
    ["Escape", "Close, restore the page, or stop probing"],
    ["?", "This list"],
  ]],
  ["3D view, after a click into it or with Tab", [
    ["Drag", "Orbit; with Ctrl turn the head; with Shift or the right button pan"],
    ["Wheel", "Zoom"],
    ["Mouse", "Say what it is, and probe the pixel of the selected OAK that shows it"],
    ["Drag a pink handle", "Resize or move the box of the region; with Shift move it up and down"],
    ["Double click", "Put a point into the centre"],
    ["W A S D, Q E", "Fly; with Shift faster"],
    ["Arrow keys", "Move the OAK by 5 cm; with Shift by 5 mm"],
    ["Page up, page down", "Raise, lower the OAK"],
    ["Alt+arrow keys", "Turn, tilt the OAK by 2°; with Shift by 0.2°"],
  ]],
  ["Images", [
    ["Mouse, arrow keys", "Probe a pixel"],
    ["Drag", "Rectangle for the statistics"],
    ["Click a thumbnail", "Show the image large; with Enter too"],
    ["Double click, Enter", "Maximize the image, or restore the page"],
    ["Wheel, +, -, 0", "Zoom; show the whole image"],
    ["Shift+drag", "Move what is zoomed into; with the middle button too"],
  ]],
  ["Number fields", [["Up, down", "One step; with Shift a tenth"]]],
];

export function Help({ onClose }: { onClose: () => void }) {
  return (
    <Dialog title="Keys" onClose={onClose}>
      <div class="keys">
        {KEYS.map(([title, keys]) => (
          <section key={title}>
            <h3>{title}</h3>
            <dl>
              {keys.map(([key, does]) => <div key={key}><dt><kbd>{key}</kbd></dt><dd>{does}</dd></div>)}
            </dl>
          </section>
        ))}
      </div>
    </Dialog>
  );
}
