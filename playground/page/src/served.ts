// The page behind `denhart view`: the arm file comes from the command, and may go back to it.

import type { App } from "./app";
import { byId, messageOf, notice } from "./dom";

/** What the command or an export writes into the page. */
export interface Given {
  text: string;
  name: string;
  /** The page is served, and asks for changes of the file. */
  follow?: boolean;
  /** The page may write the file. */
  write?: boolean;
}

/** Time between two questions, ms. */
const INTERVAL = 700;

/** Line ends as the editor has them. */
const plain = (text: string): string => text.replace(/\r\n?/g, "\n");

export function given(): Given | undefined {
  const found = JSON.parse(byId("opened").textContent || "null") as Given | null;
  return found ? { ...found, text: plain(found.text) } : undefined;
}

const token = (): string => new URLSearchParams(location.search).get("token") ?? "";

/** True for a page that the command serves: its address is worth nothing to others, and nothing once the command has ended. */
export const isServed = (): boolean => given() !== undefined && token() !== "";

/** A request to the command. */
async function request(how: RequestInit): Promise<Response> {
  try {
    return await fetch(`arm?token=${encodeURIComponent(token())}`, { cache: "no-store", ...how });
  } catch {
    throw new Error("the command has ended, or cannot be reached");
  }
}

/** Follows the file of the command. */
export function follow(app: App, from: Given): void {
  new Follow(app, from);
}

class Follow {
  /** The command's tag of `app.file`. */
  private tag = "";
  /** The file has the line ends of Windows. */
  private isCrlf = false;
  /** Why the file could not be read the last time; empty if it could. */
  private lost = "";
  /** Writes so far: an answer that was asked for before a write tells nothing any more. */
  private writes = 0;
  private readonly bar = byId("changed");
  private readonly button = byId<HTMLButtonElement>("write");

  constructor(private readonly app: App, private readonly from: Given) {
    byId("changed-words").textContent = `${from.name} has changed, and so has the text here:`;
    const round = (): void => void this.ask().finally(() => setTimeout(round, INTERVAL));
    round();
    if (!from.write) return;
    this.button.hidden = false;
    this.button.title = `Write ${from.name}`;
    this.button.addEventListener("click", () => void this.write());
  }

  private async ask(): Promise<void> {
    const { writes } = this;
    try {
      const reply = await request({});
      const text = await reply.text();
      if (!reply.ok) throw new Error(text);
      if (writes === this.writes) this.found(text, reply.headers.get("etag") ?? "");
      this.lost = "";
    } catch (error) {
      const why = messageOf(error);
      if (why !== this.lost) notice(`${this.from.name} cannot be read: ${why}`, true);
      this.lost = why;
    }
  }

  /** The file as it is now. */
  private found(raw: string, tag: string): void {
    const { app, bar } = this;
    const text = plain(raw);
    const take = (): void => {
      this.see(text, tag, raw.includes("\r\n"));
      bar.hidden = true;
    };
    if (text === app.file) {
      take();
      return;
    }
    app.flush?.();
    if (app.text === text) {
      take();
    } else if (app.text === app.file) {
      take();
      void app.setText(text);
      notice(`${this.from.name} has changed`);
    } else {
      bar.hidden = false;
      byId("take-file").onclick = () => {
        take();
        void app.setText(text);
      };
      byId("keep-mine").onclick = take;
    }
  }

  private see(text: string, tag: string, isCrlf: boolean): void {
    const { app } = this;
    this.tag = tag;
    this.isCrlf = isCrlf;
    if (text === app.file) return;
    app.file = text;
    app.emit("file");
  }

  /** Writes the file, unless it is another one than the page has seen. */
  private async write(): Promise<void> {
    const { app, from, button } = this;
    button.disabled = true;
    this.writes++;
    try {
      app.flush?.();
      const { text } = app;
      const headers = { "content-type": "text/yaml", "if-match": this.tag };
      const reply = await request({ method: "PUT", body: this.isCrlf ? text.replaceAll("\n", "\r\n") : text, headers });
      if (!reply.ok) throw new Error(await reply.text());
      this.see(text, reply.headers.get("etag") ?? "", this.isCrlf);
      this.bar.hidden = true;
      notice(`${from.name} written`);
    } catch (error) {
      notice(`${from.name} is not written: ${messageOf(error)}`, true);
    }
    this.writes++;
    button.disabled = false;
  }
}
