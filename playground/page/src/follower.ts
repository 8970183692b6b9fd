// The arm follows the target within the rates of its joints, as time goes on, instead of jumping to a solution.

import type { PageArm } from "../pkg/denhart_page.js";
import type { App } from "./app";
import { byId, messageOf, notice } from "./dom";
import { short } from "./numbers";

/** How a tick stands to its target, in the order of playground/wasm/src/follow.rs. */
const TRACKING = ["exact", "rates", "limits", "reach", "no target"];
/** The most ticks of a frame, ms: a page that was in the background does not run after the time it lost. */
const MOST = 50;
/** An arm that stands for so long without reaching its target stays there, ms. It leaves a branch after a second. */
const WAIT = 1500;

export class Follower {
  private readonly box = byId<HTMLInputElement>("follow");
  private readonly says = byId("tracking");
  private isRunning = false;
  private last = 0;
  private still = 0;
  /** What this follower left: other joint values, or another arm, begin anew. */
  private left: { q: number[]; arm: PageArm } | undefined;

  constructor(private readonly app: App) {
    this.box.addEventListener("change", () => {
      this.stop();
      if (this.box.checked) this.app.chase = () => this.run();
    });
  }

  private stop(): void {
    this.app.chase = undefined;
    this.left = undefined;
    this.says.textContent = "";
  }

  private run(): void {
    this.still = 0;
    if (this.isRunning) return;
    this.isRunning = true;
    this.last = performance.now();
    requestAnimationFrame((now) => this.frame(now));
  }

  private frame(now: number): void {
    let goesOn = false;
    this.app.timed(() => (goesOn = this.ticks(Math.min(MOST, Math.max(1, Math.round(now - this.last))))));
    this.last = now;
    this.isRunning = goesOn;
    if (goesOn) requestAnimationFrame((next) => this.frame(next));
  }

  /** True if the arm is still on its way. */
  private ticks(ticks: number): boolean {
    const { app } = this;
    const { arm } = app;
    if (!app.chase || !arm || !app.facts?.task) {
      this.says.textContent = "";
      return false;
    }
    try {
      if (this.left?.q !== app.q || this.left.arm !== arm) arm.begin(Float64Array.from(app.q));
      const numbers = arm.follow(Float64Array.from(app.target), app.angle, Float64Array.from(app.given), ticks);
      const [tracking = 4, distance = 0, angle = 0, fastest = 0] = numbers;
      app.comeTo(Array.from(numbers.subarray(4)));
      this.left = { q: app.q, arm };
      const far = tracking === 0 ? "" : `: ${short(distance)} ${app.facts.unit}, ${short((angle * 180) / Math.PI, 2)}°`;
      // The target may have solutions of other branches.
      const word = tracking === 3 && !app.miss ? "not on this branch" : (TRACKING[tracking] ?? "");
      this.says.textContent = word + far;
      this.still = fastest < 1e-6 ? this.still + ticks : 0;
      return this.still < (tracking === 0 ? 1 : WAIT);
    } catch (error) {
      // Too many joints, or a joint outside its limits: told once.
      this.box.checked = false;
      this.stop();
      notice(`the arm cannot follow from here: ${messageOf(error)}`, true);
      return false;
    }
  }
}
