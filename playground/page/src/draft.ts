// The state of the page in its entry of the browser's history: a reload shows it again, from a file too.

import type { App, Kept } from "./app";

/** Changes rest so long before they are written, ms. */
const REST = 250;

interface Draft {
  /** The text of the command's file as the page saw it last. */
  file: string | null;
  kept: Kept;
}

/** The state that the page had; `isOld` where the command has another file by now. A text that was that of the file is none. */
export function drafted(file: string | undefined): { kept: Kept; isOld: boolean } | undefined {
  const draft = (history.state as { draft?: Draft } | null)?.draft;
  if (!draft || typeof draft.kept.text !== "string" || typeof draft.kept.arm !== "string") return undefined;
  const isOld = draft.file !== (file ?? null);
  return isOld && draft.kept.text === draft.file ? undefined : { kept: draft.kept, isOld };
}

/** Writes the state down while it changes. */
export function keepDraft(app: App): void {
  let timer = 0;
  const write = (): void => {
    clearTimeout(timer);
    timer = 0;
    const draft: Draft = { file: app.file ?? null, kept: app.kept() };
    try {
      history.replaceState({ draft }, "");
    } catch {
      // A text that is too long for the browser is lost with the page.
    }
  };
  app.listen((change) => {
    if (change === "text" || change === "kept" || change === "file") timer ||= window.setTimeout(write, REST);
  });
  addEventListener("pagehide", () => {
    app.flush?.();
    if (timer) write();
  });
}
