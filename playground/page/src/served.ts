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

export function given(): Given | undefined {
  return (JSON.parse(byId("opened").textContent || "null") as Given | null) ?? undefined;
}

const token = (): string => new URLSearchParams(location.search).get("token") ?? "";

/** Follows the file of the command. */
export function follow(app: App, from: Given): void {
  let last = from.text;
  let isLost = false;
  const ask = async (): Promise<void> => {
    try {
      const reply = await fetch(`arm?token=${encodeURIComponent(token())}`, { cache: "no-store" });
      if (!reply.ok) throw new Error(await reply.text());
      const text = await reply.text();
      if (text !== last) {
        last = text;
        await app.setText(text);
        notice(`${from.name} has changed`);
      }
      isLost = false;
    } catch (error) {
      if (!isLost) notice(`${from.name} cannot be read: ${messageOf(error)}`, true);
      isLost = true;
    }
  };
  const round = (): void => void ask().finally(() => setTimeout(round, INTERVAL));
  round();
  if (!from.write) return;
  const button = byId("write");
  button.hidden = false;
  button.title = `Write ${from.name}`;
  button.addEventListener("click", () => {
    const text = app.text;
    fetch(`arm?token=${encodeURIComponent(token())}`, { method: "PUT", body: text, headers: { "content-type": "text/yaml" } })
      .then(async (reply) => {
        if (!reply.ok) throw new Error(await reply.text());
        last = text;
        notice(`${from.name} written`);
      })
      .catch((error: unknown) => notice(`${from.name} is not written: ${messageOf(error)}`, true));
  });
}
