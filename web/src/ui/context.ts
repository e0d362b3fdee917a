import { createContext } from "preact";
import { useContext } from "preact/hooks";
import type { Painter } from "../gpu/painter";
import type { Defaults } from "../studio/defaults";
import type { Studio } from "../studio/studio";
import type { SceneView } from "../studio/view";
import type { Store } from "../util/store";

/** What components share. */
export interface App {
  studio: Studio;
  defaults: Defaults;
  painter: Painter;
  /** Increases when all panels must be painted again. */
  repaint: Store<number>;
  /** The 3D view, once its canvas is on the page. */
  view: Store<SceneView | null>;
  /** What tests wait for. */
  signals: { painted: number };
}

export const AppContext = createContext<App | null>(null);

export function useApp(): App {
  const app = useContext(AppContext);
  if (!app) throw new Error("There is no studio above this component.");
  return app;
}
