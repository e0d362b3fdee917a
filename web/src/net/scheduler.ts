import type { FrameRequest } from "../protocol";

/** A request that has no number yet. */
export type Wanted = Omit<FrameRequest, "type" | "id">;

/** How many requests of one OAK may be on their way: one is computed while the next one travels. */
const IN_FLIGHT = 2;

/**
 * Limits the requests for frames: at most {@link IN_FLIGHT} per OAK; of those that wait, only the newest is sent.
 */
export class FrameScheduler {
  private readonly waiting = new Map<string, Wanted>();
  private readonly sent = new Map<string, Map<number, Wanted>>();
  private lastId = 0;

  /** `send` returns whether the request could be sent. */
  constructor(private readonly send: (request: FrameRequest) => boolean) {}

  request(wanted: Wanted): void {
    this.waiting.set(wanted.oak, wanted);
    this.flush(wanted.oak);
  }

  /**
   * Notes an answer and sends what waited for it. Returns the request, or null if its answer no longer matters. The server does not
   * answer requests that newer ones replaced, so this one settles older ones, too.
   */
  settle(oak: string, id: number): Wanted | null {
    const sent = this.sent.get(oak);
    const wanted = sent?.get(id) ?? null;
    for (const older of [...(sent?.keys() ?? [])]) if (older <= id) sent?.delete(older);
    this.flush(oak);
    return wanted;
  }

  /** Forgets an OAK that was removed. */
  forget(oak: string): void {
    this.waiting.delete(oak);
    this.sent.delete(oak);
  }

  /** Forgets everything that was on its way, for a connection that was lost. */
  reset(): void {
    this.waiting.clear();
    this.sent.clear();
  }

  /** Whether nothing waits or is on its way. */
  get isIdle(): boolean {
    return this.waiting.size === 0 && [...this.sent.values()].every((sent) => sent.size === 0);
  }

  private flush(oak: string): void {
    const wanted = this.waiting.get(oak);
    const sent = this.sent.get(oak) ?? new Map<number, Wanted>();
    if (!wanted || sent.size >= IN_FLIGHT) return;
    const id = ++this.lastId;
    if (!this.send({ type: "frame", id, ...wanted })) return;
    this.waiting.delete(oak);
    sent.set(id, wanted);
    this.sent.set(oak, sent);
  }
}
