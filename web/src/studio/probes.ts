import type { ClientMessage, ProbeAnswer, ProbeRequest } from "../protocol";
import type { Studio } from "./studio";

/** Asks the server about the pixel under the mouse: one request at a time, the newest wins. */
export class Probes {
  private send: (message: ClientMessage) => boolean = () => false;
  private inFlight: ProbeRequest | null = null;
  private waiting: Omit<ProbeRequest, "type" | "id"> | null = null;
  /** Numbers of probes and frames must differ, because a rejection does not say which of the two it rejects. */
  private lastId = 1e9;

  constructor(private readonly studio: Studio) {
    studio.hover.subscribe(() => this.follow());
  }

  connect(send: (message: ClientMessage) => boolean): void {
    this.send = send;
  }

  get isIdle(): boolean {
    return this.inFlight === null && this.waiting === null;
  }

  reset(): void {
    this.inFlight = null;
    this.waiting = null;
  }

  /** Asks again, because the OAK has a new frame. */
  refresh(oak: string): void {
    if (this.studio.hover.get()?.oak === oak) this.follow();
  }

  show(answer: ProbeAnswer): void {
    if (answer.id !== this.inFlight?.id) return;
    this.inFlight = null;
    if (this.studio.hover.get()?.oak === answer.oak) this.studio.probe.set(answer);
    this.flush();
  }

  /** Notes that a probe was rejected; returns false if it was something else that was. */
  reject(id: number, oak: string): boolean {
    if (id !== this.inFlight?.id || oak !== this.inFlight.oak) return false;
    this.inFlight = null;
    this.studio.probe.set(null);
    this.flush();
    return true;
  }

  private follow(): void {
    const hover = this.studio.hover.get();
    if (!hover) {
      this.waiting = null;
      this.studio.probe.set(null);
      return;
    }
    this.waiting = { oak: hover.oak, x: hover.x, y: hover.y };
    this.flush();
  }

  private flush(): void {
    if (this.inFlight || !this.waiting) return;
    const request: ProbeRequest = { type: "probe", id: ++this.lastId, ...this.waiting };
    if (!this.send(request)) return;
    this.waiting = null;
    this.inFlight = request;
  }
}
