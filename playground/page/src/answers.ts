// The list of solutions, the target in numbers, and the reason where there is none.

import type { App } from "./app";
import { css, inkOn, onThemeChange, solutionColor } from "./colors";
import { byId, element } from "./dom";
import { listenToField, roundStep } from "./fields";
import { APPROXIMATE, bits, BOUNDARY, degrees, FREE, OUT_OF_LIMITS, pointOf, poseOf, radians, rpy, short, type Answer, type Point } from "./numbers";
import { missWords } from "./view";

/** The names of the target's numbers. */
const NAMES = ["x", "y", "z", "roll", "pitch", "yaw"] as const;

export class Answers {
  private readonly fields: HTMLInputElement[];
  private readonly angle: HTMLInputElement;
  private readonly buttons: HTMLButtonElement[] = [];
  /** The field whose number is being taken. */
  private taken: HTMLInputElement | undefined;
  /** The value that each field stands for. */
  private readonly values = new Map<HTMLInputElement, number>();

  constructor(private readonly app: App) {
    this.fields = NAMES.map((name) => element("input", { type: "number", step: "any", "aria-label": `target ${name}` }));
    this.angle = element("input", { type: "number", step: "any", "aria-label": "target angle" });
    const labels = this.fields.map((field, index) => element("label", {}, NAMES[index]!, field));
    byId("target").replaceChildren(...labels, element("label", {}, "angle", this.angle));
    [...this.fields, this.angle].forEach((field, index) => listenToField(field, {
      step: () => (index < 3 ? roundStep((app.facts?.reach ?? 1) / 100) : 1),
      most: () => (index < 3 ? Infinity : 36_000),
      take: (value, byKey) => this.typed(field, index, value, byKey),
      restore: () => this.updateTarget(field),
    }));
    app.listen((change) => {
      if (change === "arm") this.values.clear();
      if (change === "arm" || change === "posture" || change === "marked") this.update();
    });
    onThemeChange(() => this.update());
  }

  /** A number that was typed takes its place in the target. What the other fields show is rounded, and counts for nothing. */
  private typed(field: HTMLInputElement, index: number, value: number, byKey: boolean): void {
    const { app } = this;
    let { target, angle } = app;
    if (field === this.angle) angle = radians(value);
    else if (index < 3) target = target.with(9 + index, value);
    else target = poseOf(pointOf(target), rpy(target).with(index - 3, radians(value)) as Point);
    this.taken = field;
    app.timed(() => app.aim(target, angle));
    this.taken = undefined;
    app.remember(byKey ? "target" : undefined);
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
    const inside = answer.solutions.filter(({ flags }) => !(flags & OUT_OF_LIMITS)).length;
    const counted = `${count} solution${count === 1 ? "" : "s"}`;
    const title = answer.status === "no target" ? "No target" : count === 0 ? "No solution" : inside < count ? `${counted}, ${inside} of ${count} within limits` : counted;
    say(byId("solutions-title"), title);
    const why = byId("why");
    const words = whyWords(app, answer);
    why.hidden = words === "";
    say(why, words);
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
      button.title = [
        solution.flags & FREE && "free: this joint may have any value here, with the others after it; the slider along the family changes it",
        solution.flags & BOUNDARY && "boundary: two solutions meet here; a step farther there is none",
        solution.flags & APPROXIMATE && "approximate: the nearest posture, not the target itself",
        outside && "out of limits: a joint is outside the range of the file",
      ].filter(Boolean).join("\n");
      button.className = ["solution", outside && "outside", app.pointed === index && "pointed"].filter(Boolean).join(" ");
      button.setAttribute("aria-pressed", String(index === same));
      button.style.setProperty("--color", css(solutionColor(index)));
      button.style.setProperty("--on-color", inkOn(solutionColor(index)));
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
    const solutions = app.answer?.solutions ?? [];
    const found = solutions.findIndex((solution) =>
      solution.q.every((value, joint) => {
        const off = value - (app.q[joint] ?? NaN);
        return Math.abs(app.facts?.joints[joint]?.turns ? Math.sin(off / 2) : off) < 1e-6;
      }));
    // Along a singular family the list has one member of it.
    return found < 0 && app.here.free && !app.miss && !app.chase ? app.here.place : found;
  }

  /** Shows the target. A field that is typed into keeps its text while its value is the same, unless it is to be `restored`. */
  private updateTarget(restored?: HTMLInputElement): void {
    const { app } = this;
    const task = app.facts?.task;
    byId("target-part").hidden = !task;
    if (!task || app.target.length !== 12) return;
    const values = [...pointOf(app.target), ...rpy(app.target).map(degrees)];
    const shown = [true, true, !task.startsWith("planar"), ...[task === "pose" || task === "position_axis", task === "pose" || task === "position_axis", task === "pose" || task === "position_axis" || task === "planar_pose"]];
    const show = (field: HTMLInputElement, value: number, digits: number): void => {
      const isTyped = document.activeElement === field && restored !== field;
      if (!isTyped || (this.taken !== field && this.values.get(field) !== value)) field.value = short(value, digits);
      this.values.set(field, value);
    };
    this.fields.forEach((field, index) => {
      field.parentElement!.hidden = !shown[index];
      show(field, values[index] ?? 0, 5);
    });
    this.angle.parentElement!.hidden = task !== "position_angle";
    show(this.angle, degrees(Number.isNaN(app.angle) ? 0 : app.angle), 3);
  }
}

/** Why there is no solution, or not each of them; empty where there is no more to say. */
function whyWords(app: App, answer: Answer): string {
  const { miss } = app;
  if (answer.status === "no target") return "These numbers are no pose: one is not finite, or the directions of the tool are not at right angles.";
  if (!miss) return answer.complete ? "" : "There may be more solutions than these.";
  const words = [missWords(app), miss.words && `the first equation without a root is that of ${miss.words}`].filter(Boolean);
  return words.join("; ") || "The target is too far away to tell more.";
}

/** Puts words into a live region, which would be read aloud again if they were the same. */
function say(of: HTMLElement, words: string): void {
  if (of.textContent !== words) of.textContent = words;
}
