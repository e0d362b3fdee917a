import "uplot/dist/uPlot.min.css";
import "../css/index.css";
import { render } from "preact";
import { Painter } from "./gpu/painter";
import { api } from "./net/api";
import { Defaults } from "./studio/defaults";
import { FrameLoop } from "./studio/frames";
import { Probes } from "./studio/probes";
import { Studio } from "./studio/studio";
import type { SceneView } from "./studio/view";
import { type App, AppContext } from "./ui/context";
import { Page } from "./ui/Page";
import { Store } from "./util/store";

declare global {
  interface Window {
    /** What tests wait for and change. */
    studio?: {
      readonly isIdle: boolean;
      readonly painted: number;
      readonly drawn: number;
      readonly received: number;
      readonly document: Studio["document"];
    };
  }
}

/** How long to wait before asking a server again that does not answer, ms. */
const RETRY = 1000;

function Message({ title, text }: { title: string; text: string }) {
  return <div class="message" role="alert"><h1>{title}</h1><p>{text}</p></div>;
}

function hasWebGl2(): boolean {
  return document.createElement("canvas").getContext("webgl2") !== null;
}

/** Reads what the page needs before it can show anything; waits for a server that is not there. */
async function load(root: HTMLElement): Promise<Studio> {
  for (;;) {
    try {
      const catalog = await api.catalog();
      return new Studio(catalog, await api.scene(catalog.scene));
    } catch (error) {
      render(<Message title="No server yet" text={`${error instanceof Error ? error.message : String(error)} The page tries again.`} />, root);
      await new Promise((resolve) => setTimeout(resolve, RETRY));
    }
  }
}

async function start(root: HTMLElement): Promise<void> {
  if (!hasWebGl2()) {
    const text = "This page draws with WebGL 2, which this browser does not offer. Enable hardware acceleration in its settings, "
      + "update it, or use a current Firefox, Chrome, Edge or Safari. The command line does all of this without a browser: oaktwin render --help.";
    render(<Message title="WebGL 2 is missing" text={text} />, root);
    return;
  }
  const studio = await load(root);
  const repaint = new Store(0);
  const defaults = new Defaults();
  const probes = new Probes(studio);
  const painter = new Painter(() => repaint.update((count) => count + 1));
  const app: App = { studio, defaults, painter, repaint, view: new Store<SceneView | null>(null), signals: { painted: 0 } };
  studio.document.subscribe(() => painter.keep(studio.document.get().oaks.map(({ key }) => key)));
  render(<AppContext.Provider value={app}><Page /></AppContext.Provider>, root);
  const loop = new FrameLoop(studio, probes, defaults);
  window.studio = {
    get isIdle() { return loop.isIdle && (app.view.get()?.isIdle ?? false); },
    get painted() { return app.signals.painted; },
    get drawn() { return app.view.get()?.viewer.drawn ?? 0; },
    get received() { return loop.received; },
    document: studio.document,
  };
}

const root = document.getElementById("page");
if (root) void start(root);
