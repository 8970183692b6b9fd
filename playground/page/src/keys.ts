// Keys for the whole page.

import type { App } from "./app";
import { byId } from "./dom";

/** True where letters are typed. */
function isTyping(target: EventTarget | null): boolean {
  return target instanceof HTMLElement && (target.isContentEditable || target.closest(".cm-editor") !== null || target.tagName === "TEXTAREA");
}

export function listenToKeys(app: App): void {
  addEventListener("keydown", (event) => {
    if (isTyping(event.target)) return;
    const isField = event.target instanceof HTMLInputElement && !["range", "checkbox"].includes(event.target.type);
    const key = event.key.toLowerCase();
    if ((event.ctrlKey || event.metaKey) && (key === "z" || key === "y") && !isField) {
      event.preventDefault();
      if (key === "y" || event.shiftKey) app.redo();
      else app.undo();
      return;
    }
    if (isField || event.ctrlKey || event.metaKey || event.altKey || document.querySelector("dialog[open]")) return;
    if (/^[1-9]$/.test(key)) app.choose(Number(key) - 1);
    else if (key === "m") byId("mode-translate").click();
    else if (key === "r") byId("mode-rotate").click();
    else if (key === "f") byId("show-frames").click();
    else if (key === "d") byId("show-dimensions").click();
    else if (key === "a") byId("show-axes").click();
    else if (key === "g") byId("show-ghosts").click();
    else if (key === "p") byId("presets").click();
    else if (key === "?") byId("help").click();
    else return;
    event.preventDefault();
  });
}
