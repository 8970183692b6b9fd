// The state of the page in its entry of the browser's history: a reload shows it again, from a file too.

import type { App, Kept } from "./app";

/** Changes rest so long before they are written, ms. */
const REST = 250;

interface Draft {
  /** The file that the page was given by the command: another one comes before the draft. */
  given: string | null;
  kept: Kept;
}

/** The state that the page had, unless the command has another file by now. */
export function drafted(given: string | undefined): Kept | undefined {
  const draft = (history.state as { draft?: Draft } | null)?.draft;
  const isWhole = draft && draft.given === (given ?? null) && typeof draft.kept.text === "string" && typeof draft.kept.arm === "string";
  return isWhole ? draft.kept : undefined;
}

/** Writes the state down while it changes. */
export function keepDraft(app: App, given: string | undefined): void {
  let timer = 0;
  const write = (): void => {
    clearTimeout(timer);
    timer = 0;
    const draft: Draft = { given: given ?? null, kept: app.kept() };
    try {
      history.replaceState({ draft }, "");
    } catch {
      // A text that is too long for the browser is lost with the page.
    }
  };
  app.listen((change) => {
    if (change === "text" || change === "kept") timer ||= window.setTimeout(write, REST);
  });
  addEventListener("pagehide", () => {
    app.flush?.();
    if (timer) write();
  });
}
