// The tabs on the right: generated Rust, report, pose and Jacobian, header for C, JSON.

import { StreamLanguage } from "@codemirror/language";
import { rust } from "@codemirror/legacy-modes/mode/rust";
import { EditorState, StateEffect, StateField, type Range } from "@codemirror/state";
import { Decoration, EditorView, lineNumbers, type DecorationSet } from "@codemirror/view";
import type { App } from "./app";
import { byId, copy, element, messageOf } from "./dom";
import { highlighting } from "./highlight";
import { Superseded } from "./jobs";
import { bits, degrees, pointOf, rpy, short } from "./numbers";

/** Directions of the tool, and of the base. */
const AXES = ["x", "y", "z"];

const TABS = ["rust", "report", "pose", "c", "json"] as const;
type Tab = (typeof TABS)[number];

const markNumbers = StateEffect.define<DecorationSet>();
const numbers = StateField.define<DecorationSet>({
  create: () => Decoration.none,
  update(marks, transaction) {
    for (const effect of transaction.effects) if (effect.is(markNumbers)) return effect.value;
    return marks.map(transaction.changes);
  },
  provide: (field) => EditorView.decorations.from(field),
});

export class Results {
  private tab: Tab = "rust";
  /** The text that each tab was made from. */
  private readonly made = new Map<Tab, string>();
  private readonly texts = new Map<Tab, string>();
  private readonly code: EditorView;
  /** Where numbers of the table stand in the code: of each its row. */
  private constants: { from: number; to: number; row: number }[] = [];

  constructor(private readonly app: App) {
    this.code = new EditorView({
      parent: byId("panel-rust"),
      state: EditorState.create({
        extensions: [
          EditorState.readOnly.of(true),
          EditorView.editable.of(false),
          EditorView.contentAttributes.of({ tabindex: "0", "aria-label": "Generated Rust" }),
          lineNumbers(),
          StreamLanguage.define(rust),
          highlighting,
          numbers,
          EditorView.domEventHandlers({
            mousemove: (event) => {
              const at = this.code.posAtCoords({ x: event.clientX, y: event.clientY });
              app.mark(at === null ? undefined : this.constants.find(({ from, to }) => at >= from && at <= to)?.row);
            },
            mouseleave: () => app.mark(undefined),
          }),
        ],
      }),
    });
    TABS.forEach((tab, index) => {
      const button = byId(`tab-${tab}`);
      button.addEventListener("click", () => this.open(tab));
      button.addEventListener("keydown", (event) => {
        const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
        if (!step) return;
        const next = TABS[(index + step + TABS.length) % TABS.length]!;
        this.open(next);
        byId(`tab-${next}`).focus();
      });
    });
    byId("copy").addEventListener("click", () => void copy(this.shownText(), this.tab === "rust" ? "code" : this.tab));
    byId("save").addEventListener("click", () => this.save());
    app.listen((change) => {
      if (change === "arm") this.make();
      if ((change === "posture" || change === "arm") && this.tab === "pose") this.showPose();
      if (change === "marked") this.markConstants();
    });
    this.open("rust");
  }

  open(tab: Tab): void {
    this.tab = tab;
    for (const one of TABS) {
      const button = byId(`tab-${one}`);
      button.setAttribute("aria-selected", String(one === tab));
      button.tabIndex = one === tab ? 0 : -1;
      byId(`panel-${one}`).hidden = one !== tab;
    }
    this.make();
    if (tab === "pose") this.showPose();
  }

  /** Asks the worker for what the open tab shows. */
  private make(): void {
    const { app, tab } = this;
    const text = app.armText;
    this.showWaiting();
    if (!text || tab === "pose" || this.made.get(tab) === text) return;
    const kind = tab === "rust" ? "code" : tab === "c" ? "header" : "report";
    const start = performance.now();
    app.jobs
      .run<string | string[]>({ kind, text })
      .then((made) => {
        if (Array.isArray(made)) {
          this.put("report", text, made[0] ?? "");
          this.put("json", text, made[1] ?? "");
        } else {
          this.put(tab, text, made);
        }
        byId("made-in").textContent = `made in ${Math.max(1, Math.round(performance.now() - start))} ms`;
      })
      .catch((error: unknown) => {
        if (error instanceof Superseded) return;
        this.put(tab, text, messageOf(error));
      });
  }

  /** While the tab still has the text of another arm nobody takes that along. */
  private showWaiting(): void {
    const isWaiting = this.tab !== "pose" && this.made.get(this.tab) !== this.app.armText;
    byId("results").classList.toggle("waiting", isWaiting);
    for (const id of ["copy", "save"]) byId<HTMLButtonElement>(id).disabled = isWaiting;
  }

  private put(tab: Tab, source: string, text: string): void {
    this.made.set(tab, source);
    this.texts.set(tab, text);
    this.showWaiting();
    if (tab === "rust") {
      this.code.dispatch({ changes: { from: 0, to: this.code.state.doc.length, insert: text } });
      this.findConstants(text);
      this.markConstants();
    } else {
      byId(`panel-${tab}`).querySelector("pre")!.textContent = text;
    }
  }

  /** Numbers of the code that are lengths of the table, or angles that are no multiple of 15 degrees. */
  private findConstants(text: string): void {
    const { facts } = this.app;
    this.constants = [];
    if (!facts) return;
    const same = (value: number, of: number): boolean => of !== 0 && Math.abs(value - Math.abs(of)) <= 1e-9 * Math.abs(of);
    for (const found of text.matchAll(/(?<![\w.])\d+\.\d+(?:e-?\d+)?/g)) {
      const value = Number(found[0]);
      facts.rows.forEach(({ numbers: [a, alpha, d, theta] }, row) => {
        const angles = [alpha, theta].filter((angle) => Math.abs(Math.sin(12 * angle)) > 1e-9);
        const all = [a, d, ...angles, ...angles.map(Math.sin), ...angles.map(Math.cos)];
        if (all.some((of) => same(value, of))) this.constants.push({ from: found.index, to: found.index + found[0].length, row });
      });
    }
  }

  private markConstants(): void {
    const { marked } = this.app;
    const marks: Range<Decoration>[] = this.constants
      .filter(({ row }) => row === marked)
      .map(({ from, to }) => Decoration.mark({ class: "marked-number" }).range(from, to));
    this.code.dispatch({ effects: markNumbers.of(Decoration.set(marks)) });
  }

  private showPose(): void {
    const { app } = this;
    const { arm, facts } = app;
    if (!arm || !facts) return;
    const all = Array.from(arm.jacobian(Float64Array.from(app.q)));
    const pose = all.slice(0, 12);
    const joints = facts.joints.length;
    const rows = ["vx", "vy", "vz", "wx", "wy", "wz"].map((name, row) => [name, ...all.slice(12 + row * joints, 12 + (row + 1) * joints).map((value) => short(value, 4))]);
    const rotation = [0, 1, 2].map((row) => [AXES[row]!, ...[...pose.slice(3 * row, 3 * row + 3), pose[9 + row] ?? 0].map((value) => short(value, 6))]);
    const { margins, manipulability } = JSON.parse(arm.margins(Float64Array.from(app.q))) as {
      margins: { name: string; value: number }[] | null;
      manipulability: number;
    };
    const q = app.q.map((value, joint) => (facts.joints[joint]?.turns ? degrees(value) : value));
    const shown = q.map((value, joint) => short(value, facts.joints[joint]?.turns ? 4 : 6));
    const free = bits(app.here.free, joints).map((joint) => facts.joints[joint]?.name);
    byId("panel-pose").replaceChildren(
      part("Joint values", shown.join(", "), q.join(", "), "degrees, or the length unit"),
      part(`Tool: position, ${facts.unit}`, pointOf(pose).map((value) => short(value, 6)).join(", "), pointOf(pose).join(", ")),
      part("Roll, pitch, yaw, degrees", rpy(pose).map((value) => short(degrees(value), 4)).join(", "), rpy(pose).map(degrees).join(", ")),
      part("Pose as a matrix", table(rotation, ["", ...AXES, "point"]), matrixText(pose)),
      part("Jacobian, base frame", table(rows, ["", ...facts.joints.map((joint) => joint.name)]), JSON.stringify([0, 1, 2, 3, 4, 5].map((row) => all.slice(12 + row * joints, 12 + (row + 1) * joints)))),
      part("Singularities", table([...(margins ?? []).map(({ name, value }) => [name, short(value, 4)]), ["manipulability", short(manipulability, 6)]]), JSON.stringify({ margins, manipulability }), margins ? "each factor is 0 at its singularity" : "the task has no margins"),
      ...(free.length ? [element("p", {}, `Singular here: ${free.join(", ")} may have any value of the family.`)] : []),
    );
  }

  private shownText(): string {
    return this.tab === "pose" ? this.poseText() : (this.texts.get(this.tab) ?? "");
  }

  /** The numbers of the tab, without its buttons. */
  private poseText(): string {
    const lines = [...byId("panel-pose").querySelectorAll("h3, p, tr")].map((line) =>
      line.tagName === "TR" ? [...line.children].map((cell) => cell.textContent).join("\t") : (line.tagName === "H3" ? "\n" : "") + (line.firstChild?.textContent ?? ""));
    return `${lines.join("\n").trim()}\n`;
  }

  private save(): void {
    const name = this.app.facts?.name ?? "arm";
    const ending = { rust: "rs", report: "txt", pose: "txt", c: "h", json: "json" }[this.tab];
    const link = element("a", { href: URL.createObjectURL(new Blob([this.shownText()])), download: `${name}.${ending}` });
    link.click();
    URL.revokeObjectURL(link.href);
  }
}

/** A part of the numbers with its own button to copy. */
function part(title: string, shown: string | HTMLElement, copied: string, remark = ""): HTMLElement {
  const button = element("button", { type: "button", class: "small", "aria-label": `copy ${title}` }, "copy");
  button.addEventListener("click", () => void copy(copied, title));
  const box = element("section", { class: "numbers" }, element("h3", {}, title, button), typeof shown === "string" ? element("p", { class: "mono" }, shown) : shown);
  if (remark) box.append(element("p", { class: "remark" }, remark));
  return box;
}

/** A table whose rows begin with their names, and whose columns have names or none. */
function table(rows: string[][], columns?: string[]): HTMLElement {
  const head = (scope: string) => (name: string): HTMLElement => (name ? element("th", { scope }, name) : element("td"));
  const lines = rows.map(([name = "", ...cells]) => element("tr", {}, head("row")(name), ...cells.map((cell) => element("td", {}, cell))));
  return element("table", { class: "mono" }, ...(columns ? [element("tr", {}, ...columns.map(head("col")))] : []), ...lines);
}

function matrixText(pose: number[]): string {
  const rows = [0, 1, 2].map((row) => [...pose.slice(3 * row, 3 * row + 3), pose[9 + row] ?? 0]);
  return JSON.stringify([...rows, [0, 0, 0, 1]]);
}
