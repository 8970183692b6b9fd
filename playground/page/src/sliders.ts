// A slider for each joint, with limits and units; for values given beside the target; along a singular family.

import type { App } from "./app";
import { byId, element } from "./dom";
import type { JointFacts } from "./facts";
import { listenToField, roundStep } from "./fields";
import { bits, degrees, radians, short } from "./numbers";

interface Line {
  range: HTMLInputElement;
  field: HTMLInputElement;
  row: HTMLElement;
  /** From the unit that is shown to that of the arm. */
  inner: (shown: number) => number;
  shown: (inner: number) => number;
}

export class Sliders {
  private lines: Line[] = [];
  private given: Line[] = [];
  private family: Line[] = [];
  private familyJoints = "";

  constructor(private readonly app: App) {
    app.listen((change) => {
      if (change === "arm") this.build();
      if (change === "posture") this.update();
      if (change === "arm" || change === "marked") this.mark();
    });
  }

  private build(): void {
    const { app } = this;
    const { facts } = app;
    if (!facts) return;
    this.lines = facts.joints.map((joint, index) => {
      const line = slider(joint.name, rangeOf(joint, facts.reach), joint.turns ? undefined : facts.unit, (value) => {
        app.timed(() => app.moveTo(app.q.map((old, at) => (at === index ? value : old))));
      }, (byKey) => app.remember(byKey ? `joint ${index}` : undefined));
      const track = line.range.parentElement!;
      track.classList.toggle("has-low", joint.low !== null);
      track.classList.toggle("has-high", joint.high !== null);
      const ends = (end: number | null): string =>
        end === null ? "no limit" : joint.turns ? `${short(degrees(end), 1)}°` : `${short(end)} ${facts.unit}`;
      line.row.title = `${joint.name}: ${joint.turns ? "turns" : "slides"}, from ${ends(joint.low)} to ${ends(joint.high)}`;
      line.row.addEventListener("pointerenter", () => app.mark(joint.row));
      line.row.addEventListener("pointerleave", () => app.mark(undefined));
      line.range.addEventListener("focus", () => app.mark(joint.row));
      line.range.addEventListener("blur", () => app.mark(undefined));
      return line;
    });
    byId("sliders").replaceChildren(...this.lines.map((line) => line.row));
    this.given = facts.given.map((given, index) =>
      slider(given.name, given.range, given.slides ? facts.unit : undefined, (value) => {
        app.timed(() => app.give(app.given.map((old, at) => (at === index ? value : old))));
      }, (byKey) => app.remember(byKey ? `given ${index}` : undefined)));
    const box = byId("given");
    box.replaceChildren(...this.given.map((line) => line.row));
    box.parentElement!.hidden = this.given.length === 0;
    this.familyJoints = "";
    this.family = [];
  }

  private update(): void {
    const { app } = this;
    const outside = new Set(bits(app.figure?.outside ?? 0, this.lines.length));
    this.lines.forEach((line, joint) => {
      set(line, app.q[joint] ?? 0);
      line.row.classList.toggle("outside", outside.has(joint));
      line.row.classList.toggle("free", ((app.here.free >> joint) & 1) === 1);
    });
    this.given.forEach((line, index) => set(line, app.given[index] ?? 0));
    this.updateFamily();
  }

  /** The free joints of a singular posture. */
  private updateFamily(): void {
    const { app } = this;
    const facts = app.facts;
    if (!facts) return;
    const joints = bits(app.here.free, facts.joints.length);
    const key = joints.join(" ");
    const box = byId("family");
    // While a slider is held its row stays, even where the posture is no longer singular.
    if (key !== this.familyJoints && !box.contains(document.activeElement)) {
      this.familyJoints = key;
      this.family = joints.map((joint) => {
        const { name, turns } = facts.joints[joint]!;
        return slider(name, rangeOf(facts.joints[joint]!, facts.reach), turns ? undefined : facts.unit, (value) => {
          app.timed(() => app.slide(joint, value));
        }, (byKey) => app.remember(byKey ? `family ${joint}` : undefined));
      });
      box.replaceChildren(...this.family.map((line) => line.row));
    }
    byId("family-part").hidden = this.family.length === 0;
    const shown = this.familyJoints === "" ? [] : this.familyJoints.split(" ").map(Number);
    shown.forEach((joint, index) => {
      const line = this.family[index];
      if (line) set(line, app.q[joint] ?? 0);
    });
  }

  private mark(): void {
    this.lines.forEach((line, joint) => {
      line.row.classList.toggle("marked", this.app.marked !== undefined && this.app.facts?.joints[joint]?.row === this.app.marked);
    });
  }
}

/** The ends of a joint's slider: its limits; where it has none a whole turn, or the reach to both sides. */
function rangeOf({ turns, low, high }: JointFacts, reach: number | null): [number, number] {
  const free = turns ? Math.PI : (reach ?? 1);
  // One limit may lie beyond the other end.
  return [low ?? Math.min(-free, (high ?? free) - 2 * free), high ?? Math.max(free, (low ?? -free) + 2 * free)];
}

/** So many turns, or ranges of a slide, is a number that was meant otherwise. */
const MOST = 20;

/** A slider with its number. Without a unit of length it is an angle, shown in degrees. `done` is told of arrow keys. */
export function slider(
  name: string,
  [low, high]: [number, number],
  unit: string | undefined,
  input: (value: number) => void,
  done: (byKey: boolean) => void,
): Line {
  const shown = unit === undefined ? degrees : (value: number) => value;
  const inner = unit === undefined ? radians : (value: number) => value;
  const step = unit === undefined ? 0.1 : roundStep(Math.max((high - low) / 100, 1e-9));
  const range = element("input", { type: "range", min: shown(low), max: shown(high), step: "any", "aria-label": name });
  const field = element("input", { type: "number", step: "any", "aria-label": `${name}, ${unit ?? "degrees"}` });
  const row = element("label", { class: "slider" }, element("span", { class: "name" }, name), element("span", { class: "track" }, range), field, element("span", { class: "unit" }, unit ?? "°"));
  const take = (text: string): void => {
    const value = Number(text);
    if (text.trim() !== "" && Number.isFinite(value)) input(inner(value));
  };
  range.addEventListener("input", () => take(range.value));
  range.addEventListener("change", () => done(false));
  // Steps of "any" leave the arrow keys without one.
  range.addEventListener("keydown", (event) => {
    const sign = { ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1 }[event.key];
    if (!sign) return;
    event.preventDefault();
    const by = event.shiftKey ? 10 : 1;
    const [least, most] = [Number(range.min), Number(range.max)];
    const next = Math.min(Math.max(Number(range.value) + (sign * by * (most - least)) / 360, least), most);
    take(String(next));
    done(true);
  });
  const line: Line = { range, field, row, inner, shown };
  listenToField(field, {
    step: () => step,
    most: () => MOST * (unit === undefined ? 360 : high - low),
    take: (value, byKey) => {
      input(inner(value));
      done(byKey);
    },
    restore: () => (field.value = short(Number(range.dataset.value), 4)),
  });
  return line;
}

/** Shows a value. A field that is being typed into keeps its text while that is the value. */
function set(line: Line, value: number): void {
  const shown = line.shown(value);
  if (Number.isNaN(shown)) {
    line.field.value = "";
    return;
  }
  line.range.value = String(shown);
  line.range.dataset.value = String(shown);
  const isTyped = document.activeElement === line.field && Math.abs(Number(line.field.value) - shown) <= 1e-3;
  if (!isTyped) line.field.value = short(shown, 4);
}
