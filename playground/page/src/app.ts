// The state of the page, and what changes it. Everything that is shown listens.

import { PageArm } from "../pkg/denhart_page.js";
import { messageOf } from "./dom";
import type { Facts, Message } from "./facts";
import { History } from "./history";
import { Jobs, Superseded } from "./jobs";
import { DEEPEST, isTooDeep } from "./nesting";
import { answerOf, APPROXIMATE, EXACT, figureOf, type Answer, type Figure, type Pose } from "./numbers";

/** An arm file is a page or two. Longer texts are something else. */
export const LONGEST_TEXT = 100_000;

export type Change = "text" | "messages" | "arm" | "posture" | "marked" | "shown" | "kept" | "framed" | "file";

/** Why there is no solution. */
export interface Miss {
  words: string;
  distance: number | null;
  direction: number | null;
}

/** A state to come back to. */
export interface Snapshot {
  text: string;
  q: number[];
  target: Pose;
  angle: number;
  given: number[];
}

/** A state of the page: the text as it is typed, and the last one without mistakes, whose arm is shown. */
export interface Kept extends Snapshot {
  arm: string;
}

/** The posture of the arm as a member of the target's solutions. */
interface Here {
  flags: number;
  free: number;
  /** The place of its branch among the solutions of the target, from 0; -1 for none. */
  place: number;
}

export class App {
  text = "";
  messages: Message[] = [];
  arm: PageArm | undefined;
  facts: Facts | undefined;
  /** The text of `arm`: the last one without mistakes. */
  armText = "";
  q: number[] = [];
  figure: Figure | undefined;
  target: Pose = [];
  angle = NaN;
  given: number[] = [];
  answer: Answer | undefined;
  branches: string[] = [];
  here: Here = { flags: 0, free: 0, place: -1 };
  miss: Miss | undefined;
  /** The row of the table that is marked, from 0. */
  marked: number | undefined;
  /** The ghost that is pointed at. */
  pointed: number | undefined;
  shown = { ghosts: true, frames: false, dimensions: false, axes: false, names: true };
  /** Times of the handlers that move the arm, ms. */
  times: number[] = [];
  readonly history = new History<Kept>();
  /** The text of the command's file as the page saw it last; none where the page has no file. */
  file: string | undefined;
  /** Brings the arm to the target as time goes on; unset, it jumps to the solution next to it. */
  chase: (() => void) | undefined;

  /** Takes over what the editor has not handed on yet. */
  flush: (() => void) | undefined;

  private readonly listeners: ((change: Change) => void)[] = [];
  private asked = 0;
  private chosen = 0;
  private checking: Promise<void> = Promise.resolve();
  private missTimer = 0;
  private restoring = false;

  constructor(readonly jobs: Jobs) {}

  listen(listener: (change: Change) => void): void {
    this.listeners.push(listener);
  }

  emit(change: Change): void {
    for (const listener of this.listeners) {
      try {
        listener(change);
      } catch (error) {
        // The others are told all the same.
        reportError(error);
      }
    }
  }

  /** A text is about to come, a file that is read say: its number, for `isLatest`. */
  announce(): number {
    this.flush?.();
    return ++this.chosen;
  }

  /** True while nothing was chosen or typed after the text of this number. */
  isLatest(number: number): boolean {
    this.flush?.();
    return number === this.chosen;
  }

  /** Waits until what is typed is checked. */
  async settle(): Promise<void> {
    this.flush?.();
    await this.checking;
  }

  /** Shows an arm before the worker has said anything of it: one that was an arm before, for it blocks the page. */
  begin(text: string, posture?: Partial<Snapshot>): void {
    this.text = text;
    try {
      this.take(text, posture);
    } catch {
      // The mistakes are told with their places soon.
    }
  }

  /** Takes a text that comes in place of the one that was typed: undo comes back to that. */
  async setText(text: string, posture?: Partial<Snapshot>): Promise<void> {
    this.keepTyped();
    await this.check(text, posture);
  }

  /** Takes a text as it is typed: it is checked in the worker, and becomes the arm if it has no mistake. */
  check(text: string, posture?: Partial<Snapshot>): Promise<void> {
    this.checking = this.checked(text, posture);
    return this.checking;
  }

  private async checked(text: string, posture?: Partial<Snapshot>): Promise<void> {
    const asked = ++this.asked;
    this.chosen++;
    this.text = text;
    this.emit("text");
    const refused = refusal(text);
    if (refused) {
      this.show([{ severity: "error", message: refused }]);
      return;
    }
    let messages: Message[];
    try {
      messages = await this.jobs.run<Message[]>({ kind: "messages", text });
    } catch (error) {
      if (error instanceof Superseded) return;
      messages = [{ severity: "error", message: messageOf(error) }];
    }
    if (asked !== this.asked) return;
    const isNew = text !== this.armText || posture !== undefined;
    if (isNew && !messages.some((message) => message.severity === "error")) {
      try {
        this.take(text, posture);
      } catch (error) {
        messages = [...messages, { severity: "error", message: messageOf(error) }];
      }
    }
    this.show(messages);
  }

  private show(messages: Message[]): void {
    this.messages = messages;
    this.emit("messages");
  }

  /** Makes the arm of a text without mistakes. */
  private take(text: string, posture: Partial<Snapshot> = {}): void {
    const arm = new PageArm(text);
    const facts = JSON.parse(arm.facts()) as Facts;
    const joints = facts.joints.length;
    const is = (q: number[] | undefined): q is number[] => q?.length === joints && q.every(Number.isFinite);
    const same = this.facts && this.facts.joints.every((joint, index) => joint.turns === facts.joints[index]?.turns);
    const q = is(posture.q) ? posture.q : same && is(this.q) ? this.q : Array.from(arm.apart());
    // May throw: nothing has changed until here.
    const figure = figureOf(arm.figure(Float64Array.from(q)), joints);
    const before = this.facts;
    this.arm?.free();
    this.arm = arm;
    this.facts = facts;
    this.armText = text;
    this.q = q;
    this.figure = figure;
    this.marked = undefined;
    this.pointed = undefined;
    // Nothing of the arm before is left for those who listen.
    this.target = figure.tool;
    this.angle = NaN;
    this.given = [];
    this.answer = undefined;
    this.branches = [];
    this.miss = undefined;
    this.here = { flags: 0, free: 0, place: -1 };
    this.emit("arm");
    this.moveTo(q);
    if (this.isOther(before)) this.emit("framed");
    if (posture.target?.length === 12 && posture.target.every(Number.isFinite) && this.facts.task) {
      this.given = posture.given?.length === this.given.length ? posture.given : this.given;
      this.aim(posture.target, posture.angle ?? this.angle);
      if (is(posture.q)) this.stand(posture.q);
    }
    this.remember();
  }

  /** True for an arm that is not the one before with other numbers: the picture looks at it anew. */
  private isOther(before: Facts | undefined): boolean {
    const { facts } = this;
    if (!before || !facts) return true;
    return before.name !== facts.name || before.unit !== facts.unit || before.joints.length !== facts.joints.length;
  }

  /** Runs a handler and notes its time. */
  timed(handler: () => void): void {
    const start = performance.now();
    handler();
    this.times.push(performance.now() - start);
    if (this.times.length > 2000) this.times.shift();
  }

  /** The arm goes to joint values, and the target with it. */
  moveTo(q: number[]): void {
    const { arm, facts } = this;
    if (!arm || !facts || !q.every(Number.isFinite)) return;
    const values = Float64Array.from(q);
    this.q = q;
    this.figure = figureOf(arm.figure(values), facts.joints.length);
    this.target = this.figure.tool;
    this.angle = arm.angle(values);
    this.given = facts.task ? Array.from(arm.held(values)) : [];
    this.solve();
    this.emit("posture");
  }

  /** The target goes to a pose, and the arm to the solution next to where it is. */
  aim(target: Pose, angle = this.angle): void {
    const { arm, facts } = this;
    if (!arm || !facts?.task || !target.every(Number.isFinite)) return;
    this.target = target;
    this.angle = angle;
    this.solve();
    const next = this.chase ? undefined : this.next(this.q);
    if (next) this.stand(next);
    this.emit("posture");
    this.chase?.();
  }

  /** The arm has come to joint values on its way to the target. */
  comeTo(q: number[]): void {
    this.stand(q);
    this.emit("posture");
  }

  /** Values beside the target change: the redundant joints, or the arm angle. */
  give(given: number[]): void {
    if (!this.arm || !this.facts?.task) return;
    this.given = given;
    this.solve();
    if (this.chase) {
      this.emit("posture");
      this.chase();
      return;
    }
    // The nearest of all solutions: those near a posture would keep its own values.
    let [best, least] = [undefined as number[] | undefined, Infinity];
    for (const solution of this.answer?.solutions ?? []) {
      const far = Math.hypot(...solution.q.map((value, joint) => Math.sin((value - (this.q[joint] ?? 0)) / 2)));
      if (far < least) [best, least] = [solution.q, far];
    }
    if (best) this.stand(best);
    this.emit("posture");
  }

  /** Takes a solution. */
  choose(index: number): void {
    const solution = this.answer?.solutions[index];
    if (!solution) return;
    this.stand(solution.q);
    this.emit("posture");
    this.remember();
  }

  /** Goes along a singular family: a free joint gets a value, and the others follow. */
  slide(joint: number, value: number): void {
    const reference = this.q.slice();
    reference[joint] = value;
    const next = this.next(reference);
    if (next) this.stand(next);
    this.emit("posture");
  }

  /** The solution of the target next to a joint vector. */
  private next(reference: number[]): number[] | undefined {
    const { arm, facts } = this;
    if (!arm || !facts) return undefined;
    const found = arm.nearest(Float64Array.from(this.target), this.angle, Float64Array.from(reference));
    return found.length === facts.joints.length + 3 ? Array.from(found.subarray(3)) : undefined;
  }

  /** The arm stands at joint values, and the target stays. */
  private stand(q: number[]): void {
    const { arm, facts } = this;
    if (!arm || !facts) return;
    this.q = q;
    this.figure = figureOf(arm.figure(Float64Array.from(q)), facts.joints.length);
    this.look();
  }

  private look(): void {
    const found = this.arm?.nearest(Float64Array.from(this.target), this.angle, Float64Array.from(this.q));
    this.here = { flags: found?.[0] ?? 0, free: found?.[1] ?? 0, place: found?.[2] ?? -1 };
  }

  private solve(): void {
    const { arm, facts } = this;
    this.answer = undefined;
    this.branches = [];
    this.here = { flags: 0, free: 0, place: -1 };
    this.miss = undefined;
    clearTimeout(this.missTimer);
    if (!arm || !facts?.task) return;
    const numbers = arm.solve(Float64Array.from(this.target), this.angle, Float64Array.from(this.given));
    this.answer = answerOf(numbers, facts.joints.length);
    this.branches = arm.branches().split("\n");
    this.look();
    if (this.answer.status === "no target") return;
    const reached = this.answer.solutions.some((solution) => solution.flags & (EXACT | APPROXIMATE));
    if (!reached) {
      this.miss = { words: arm.why(Float64Array.from(this.target), this.angle, Float64Array.from(this.given)), distance: null, direction: null };
      // The closest approach takes an iteration: it waits until the target stands still.
      this.missTimer = window.setTimeout(() => this.closest(), 200);
    }
  }

  private closest(): void {
    if (!this.arm || !this.miss) return;
    const found = JSON.parse(this.arm.closest(Float64Array.from(this.target), this.angle, Float64Array.from(this.q))) as
      | { distance: number | null; direction: number | null }
      | null;
    if (!found) return;
    this.miss = { ...this.miss, distance: found.distance, direction: found.direction };
    this.emit("posture");
  }

  mark(row: number | undefined): void {
    if (row === this.marked) return;
    this.marked = row;
    this.emit("marked");
  }

  point(ghost: number | undefined): void {
    if (ghost === this.pointed) return;
    this.pointed = ghost;
    this.emit("marked");
  }

  snapshot(): Snapshot {
    const { armText, q, target, angle, given } = this;
    return { text: armText, q: q.slice(), target: target.slice(), angle, given: given.slice() };
  }

  /** The state of the page. */
  kept(): Kept {
    return { ...this.snapshot(), text: this.text, arm: this.armText };
  }

  /** A state that undo comes back to. One of the same `series` as the last one, a moment later, takes its place. */
  remember(series?: string): void {
    if (this.arm && !this.restoring) this.history.push(this.kept(), series);
    this.emit("kept");
  }

  /** Typed text becomes a state before another text takes its place: one with mistakes was none until now. */
  private keepTyped(): void {
    this.flush?.();
    if (this.isTyped() && this.text.length <= LONGEST_TEXT) this.history.push(this.kept());
  }

  /** True where the text is not that of the last state. */
  private isTyped(): boolean {
    const last = this.history.present();
    return this.arm !== undefined && last !== undefined && last.text !== this.text;
  }

  get canUndo(): boolean {
    return this.history.has(-1) || this.isTyped();
  }

  get canRedo(): boolean {
    return this.history.has(1) && !this.isTyped();
  }

  undo(): void {
    this.keepTyped();
    // A text that is too long to keep goes away.
    this.restore(this.isTyped() ? this.history.present() : this.history.go(-1));
  }

  redo(): void {
    this.keepTyped();
    this.restore(this.history.go(1));
  }

  private restore(state: Kept | undefined): void {
    if (!state) return;
    this.chosen++;
    this.restoring = true;
    try {
      if (state.arm !== this.armText) this.take(state.arm, state);
      else this.pose(state);
    } catch (error) {
      // It was an arm before.
      this.show([{ severity: "error", message: messageOf(error) }]);
    } finally {
      this.restoring = false;
    }
    if (state.text !== this.text) void this.check(state.text);
    this.emit("kept");
  }

  private pose(state: Kept): void {
    this.moveTo(state.q);
    if (!this.facts?.task) return;
    this.given = state.given;
    this.aim(state.target, state.angle ?? this.angle);
    this.stand(state.q);
    this.emit("posture");
  }
}

/** Why a text is no arm file, as far as that is seen without reading it; empty where it may be one. */
function refusal(text: string): string {
  if (text.length > LONGEST_TEXT) return `this text has ${Math.round(text.length / 1000)} kB: no arm file is longer than ${LONGEST_TEXT / 1000} kB`;
  return isTooDeep(text) ? `this text nests more than ${DEEPEST} brackets or lists: no arm file does` : "";
}
