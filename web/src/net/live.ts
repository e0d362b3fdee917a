import type { ClientMessage, ImageName, ServerMessage } from "../protocol";
import { decodeFrame, type Frame, type Picture } from "./wire";

export type Connection = "connecting" | "open" | "lost";

export interface LiveHandlers {
  onConnection(connection: Connection): void;
  onFrame(frame: Frame): void;
  onMessage(message: ServerMessage): void;
}

/** The waits between attempts to reconnect, ms; the last one repeats. */
const WAITS = [200, 500, 1000, 2000];

/** The WebSocket to the server, which connects again after it was closed. */
export class Live {
  private socket: WebSocket | null = null;
  private attempts = 0;
  /** The last image of each name of each OAK on this connection. */
  private readonly pictures = new Map<string, Map<ImageName, Picture>>();

  constructor(private readonly handlers: LiveHandlers) {}

  connect(): void {
    const scheme = location.protocol === "https:" ? "wss:" : "ws:";
    const socket = new WebSocket(`${scheme}//${location.host}/api/live`);
    socket.binaryType = "arraybuffer";
    socket.onopen = () => {
      this.socket = socket;
      this.attempts = 0;
      this.pictures.clear();
      this.handlers.onConnection("open");
    };
    socket.onmessage = ({ data }: MessageEvent<string | ArrayBuffer>) => {
      if (typeof data === "string") this.handlers.onMessage(JSON.parse(data) as ServerMessage);
      else this.handlers.onFrame(this.decode(data));
    };
    socket.onclose = () => {
      this.socket = null;
      this.handlers.onConnection("lost");
      const wait = WAITS[Math.min(this.attempts++, WAITS.length - 1)];
      setTimeout(() => this.connect(), wait);
    };
  }

  private decode(data: ArrayBuffer): Frame {
    const frame = decodeFrame(data, (oak) => this.pictures.get(oak));
    const { oak } = frame.header;
    this.pictures.set(oak, new Map([...(this.pictures.get(oak) ?? []), ...frame.pictures]));
    return frame;
  }

  /** Sends a message; returns whether there is a connection. */
  send(message: ClientMessage): boolean {
    if (this.socket?.readyState !== WebSocket.OPEN) return false;
    this.socket.send(JSON.stringify(message));
    return true;
  }
}
