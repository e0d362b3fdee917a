import type { StudioDocument } from "../state/document";
import { Store } from "../util/store";
import type { Studio } from "./studio";

/** What a document can name by its id, with what it is in messages. */
const KINDS = { trajectory: "trajectory", motion: "list of postures" } as const;

/** The dropped files of a kind that the page knows, by id. It asks the server for the one of a link, or of a page that was loaded again. */
export class Known<T extends { id: string }> {
  readonly all = new Store<ReadonlyMap<string, T>>(new Map());
  private loading = "";

  /** `without` is the document if the server does not have its file. */
  constructor(
    private readonly studio: Studio,
    private readonly kind: keyof typeof KINDS,
    private readonly ask: (id: string) => Promise<T>,
    private readonly without: (document: StudioDocument) => StudioDocument = (document) => document,
  ) {
    studio.document.subscribe(() => void this.load());
    void this.load();
  }

  /** The one that the document names. */
  current(): T | null {
    return this.all.get().get(this.studio.document.get()[this.kind] ?? "") ?? null;
  }

  learn(info: T): void {
    this.all.set(new Map(this.all.get()).set(info.id, info));
  }

  private async load(): Promise<void> {
    const { document } = this.studio;
    const id = document.get()[this.kind];
    if (id === null || this.all.get().has(id) || this.loading === id) return;
    this.loading = id;
    try {
      this.learn(await this.ask(id));
    } catch {
      if (document.get()[this.kind] !== id) return;
      this.studio.notify("warning", `The server does not have the ${KINDS[this.kind]} of this state; drop its file onto the page again.`);
      document.set({ ...this.without(document.get()), [this.kind]: null });
    } finally {
      this.loading = "";
    }
  }
}
