// The list of solutions, the target in numbers, and the reason where there is none.

import type { App } from "./app";
import { css, onThemeChange, solutionColor } from "./colors";
import { byId, element } from "./dom";
import { APPROXIMATE, bits, BOUNDARY, degrees, FREE, OUT_OF_LIMITS, pointOf, poseOf, radians, rpy, short, type Point } from "./numbers";
import { missWords } from "./view";

/** The names of the target's numbers. */
const NAMES = ["x", "y", "z", "roll", "pitch", "yaw"] as const;

export class Answers {
  private readonly fields: HTMLInputElement[];
  private readonly angle: HTMLInputElement;
  private readonly buttons: HTMLButtonElement[] = [];

  constructor(private readonly app: App) {
    this.fields = NAMES.map((name) => element("input", { type: "number", step: "any", "aria-label": `target ${name}` }));
    this.angle = element("input", { type: "number", step: "any", "aria-label": "target angle" });
    const labels = this.fields.map((field, index) => element("label", {}, NAMES[index]!, field));
    byId("target").replaceChildren(...labels, element("label", {}, "angle", this.angle));
    for (const field of [...this.fields, this.angle]) field.addEventListener("change", () => this.typed());
    app.listen((change) => {
      if (change === "arm" || change === "posture" || change === "marked") this.update();
    });
    onThemeChange(() => this.update());
  }

  /** The numbers as they were typed become the target. */
  private typed(): void {
    const values = this.fields.map((field) => (field.value.trim() === "" ? NaN : Number(field.value)));
    const angle = Number(this.angle.value);
    if (!values.every(Number.isFinite) || !Number.isFinite(angle)) {
      this.update();
      return;
    }
    const [x, y, z, roll, pitch, yaw] = values as [number, number, number, number, number, number];
    this.app.timed(() => this.app.aim(poseOf([x, y, z], [roll, pitch, yaw].map(radians) as Point), radians(angle)));
    this.app.remember();
  }

  private update(): void {
    const { app } = this;
    const { facts, answer } = app;
    if (!facts) return;
    this.updateTarget();
    const list = byId("solutions");
    byId("solutions-part").hidden = facts.task === null;
    const reason = byId("no-inverse");
    reason.hidden = facts.noInverse === null;
    reason.textContent = facts.noInverse ?? "";
    if (!answer) {
      list.replaceChildren();
      return;
    }
    const count = answer.solutions.length;
    byId("solutions-title").textContent =
      answer.status === "no target" ? "No target" : count === 0 ? "No solution" : `${count} solution${count === 1 ? "" : "s"}`;
    const why = byId("why");
    why.hidden = !app.miss && answer.complete;
    why.textContent = app.miss
      ? [missWords(app), app.miss.words].filter(Boolean).join("; ") || "The target is too far away to tell more."
      : answer.complete ? "" : "There may be more solutions than these.";
    const same = this.same();
    while (this.buttons.length < count) this.buttons.push(this.button(this.buttons.length));
    if (list.children.length !== count) list.replaceChildren(...this.buttons.slice(0, count));
    answer.solutions.forEach((solution, index) => {
      const values = solution.q.map((value, joint) => (facts.joints[joint]?.turns ? short(degrees(value), 0) : short(value, 3)));
      const name = app.branches[index] === "-" ? "" : (app.branches[index] ?? "");
      const outside = (solution.flags & OUT_OF_LIMITS) !== 0;
      const marks = [
        solution.flags & FREE && `free: ${bits(solution.free, values.length).map((joint) => facts.joints[joint]?.name).join(", ")}`,
        solution.flags & BOUNDARY && "boundary",
        solution.flags & APPROXIMATE && "approximate",
        outside && "out of limits",
      ].filter(Boolean);
      const button = this.buttons[index]!;
      button.className = ["solution", outside && "outside", app.pointed === index && "pointed"].filter(Boolean).join(" ");
      button.setAttribute("aria-pressed", String(index === same));
      button.style.setProperty("--color", css(solutionColor(index)));
      const [, branch, numbers] = button.children;
      branch!.textContent = [name, ...marks].filter(Boolean).join(", ");
      numbers!.textContent = values.join("  ");
    });
  }

  /** The button of a solution, which stays while its numbers change. */
  private button(index: number): HTMLButtonElement {
    const parts = [element("span", { class: "number" }, String(index + 1)), element("span", { class: "branch" }), element("span", { class: "values" })];
    const button = element("button", { type: "button" }, ...parts);
    button.addEventListener("click", () => this.app.choose(index));
    button.addEventListener("pointerenter", () => this.app.point(index));
    button.addEventListener("pointerleave", () => this.app.point(undefined));
    button.addEventListener("focus", () => this.app.point(index));
    button.addEventListener("blur", () => this.app.point(undefined));
    return button;
  }

  /** The solution at which the arm stands. */
  private same(): number {
    const { app } = this;
    return (app.answer?.solutions ?? []).findIndex((solution) =>
      solution.q.every((value, joint) => {
        const off = value - (app.q[joint] ?? NaN);
        return Math.abs(app.facts?.joints[joint]?.turns ? Math.sin(off / 2) : off) < 1e-6;
      }));
  }

  private updateTarget(): void {
    const { app } = this;
    const task = app.facts?.task;
    byId("target-part").hidden = !task;
    if (!task || app.target.length !== 12) return;
    const values = [...pointOf(app.target), ...rpy(app.target).map(degrees)];
    const shown = [true, true, !task.startsWith("planar"), ...[task === "pose" || task === "position_axis", task === "pose" || task === "position_axis", task === "pose" || task === "position_axis" || task === "planar_pose"]];
    this.fields.forEach((field, index) => {
      field.parentElement!.hidden = !shown[index];
      if (document.activeElement !== field) field.value = short(values[index] ?? 0, 5);
    });
    this.angle.parentElement!.hidden = task !== "position_angle";
    if (document.activeElement !== this.angle) this.angle.value = short(degrees(Number.isNaN(app.angle) ? 0 : app.angle), 3);
  }
}
