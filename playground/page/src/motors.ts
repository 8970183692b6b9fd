// Motors that count pulses: the counts of the posture, and a log of the lines that would be sent. The text is that of docs/motors.md.

import type { App } from "./app";
import { byId, copy, element } from "./dom";

/** Lines that are kept. */
const MOST = 60;

/** The line of a move: the counts of all motors, and the exclusive or of the bytes before the star. */
export function moveLine(counts: number[]): string {
  const words = ["MOVE", ...counts.map(String)].join(" ");
  const sum = [...words].reduce((all, letter) => all ^ letter.charCodeAt(0), 0);
  return `${words}*${sum.toString(16).toUpperCase().padStart(2, "0")}`;
}

export class Motors {
  private lines: string[] = [];

  constructor(private readonly app: App) {
    byId("lines-copy").addEventListener("click", () => void copy(`${this.lines.join("\n")}\n`, "lines"));
    app.listen((change) => {
      if (change === "arm") this.lines = [];
      if (change === "arm" || change === "posture") this.showCounts();
      if (change === "kept") this.add();
    });
  }

  private counts(): number[] {
    const { app } = this;
    return app.arm && app.facts?.pulses ? Array.from(app.arm.pulses(Float64Array.from(app.q))) : [];
  }

  private showCounts(): void {
    const counts = this.counts();
    byId("motors-part").hidden = counts.length === 0;
    byId("counts").textContent = counts.map((count, motor) => `${this.app.facts?.joints[motor]?.name ?? ""} ${count}`).join("   ");
  }

  /** A posture that is kept would be sent. */
  private add(): void {
    const counts = this.counts();
    if (counts.length === 0) return;
    const line = moveLine(counts);
    if (line === this.lines.at(-1)) return;
    this.lines = [...this.lines, line].slice(-MOST);
    byId("lines").replaceChildren(...this.lines.map((one) => element("li", {}, one)));
    byId("lines").lastElementChild?.scrollIntoView({ block: "nearest" });
  }
}
