// Words over the picture: it is that of an older text, the arm is near a singularity.

import type { App } from "./app";
import { byId } from "./dom";
import { short } from "./numbers";

/** A margin above this is none to speak of: the links have no color of their own. */
export const NEAR_SINGULAR = 0.12;

export function listenForRemarks(app: App): void {
  const [stale, near] = [byId("stale"), byId("near")];
  stale.addEventListener("click", () => {
    // On a phone the text is in another part.
    byId("go-table").click();
    byId("messages").querySelector("button")?.click();
  });
  app.listen((change) => {
    if (change === "messages") {
      const isStale = app.arm !== undefined && app.messages.some((message) => message.severity === "error");
      stale.hidden = !isStale;
      stale.textContent = `The arm file has mistakes: this is still ${app.facts?.name ?? "the arm before"}`;
    }
    if (change !== "arm" && change !== "posture") return;
    const { arm, figure } = app;
    const isNear = arm !== undefined && figure !== undefined && figure.margin < NEAR_SINGULAR / 2;
    near.hidden = !isNear;
    if (!isNear) return;
    const { margins } = JSON.parse(arm.margins(Float64Array.from(app.q))) as { margins: { name: string; value: number }[] | null };
    const least = (margins ?? []).sort((a, b) => Math.abs(a.value) - Math.abs(b.value))[0];
    const isAt = figure.margin < 1e-6;
    near.textContent = `${isAt ? "at" : "near"} a singularity${least ? `: ${least.name} ${short(least.value, 3)}` : ""}`;
  });
}
