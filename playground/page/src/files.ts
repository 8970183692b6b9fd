// Files that are dropped or opened: arm files, URDFs, calibrations; and the arm file to save.

import type { App } from "./app";
import { byId, element, messageOf, notice } from "./dom";

/** Longer files are no description of an arm. */
const LONGEST = 5_000_000;

export class Files {
  constructor(private readonly app: App) {
    const input = byId<HTMLInputElement>("file");
    byId("open").addEventListener("click", () => input.click());
    input.addEventListener("change", () => {
      const [file] = input.files ?? [];
      if (file) void this.take(file);
      input.value = "";
    });
    addEventListener("dragover", (event) => {
      if (!event.dataTransfer?.types.includes("Files")) return;
      event.preventDefault();
      document.body.classList.add("dropping");
    });
    addEventListener("dragleave", (event) => {
      if (!event.relatedTarget) document.body.classList.remove("dropping");
    });
    // Before the editor, which would take the text of the file.
    addEventListener("drop", (event) => {
      document.body.classList.remove("dropping");
      const [file] = event.dataTransfer?.files ?? [];
      if (!file) return;
      event.preventDefault();
      event.stopPropagation();
      void this.take(file);
    }, true);
    byId("save-arm").addEventListener("click", () => {
      app.flush?.();
      const { text, armText, facts } = this.app;
      // A text with mistakes is no arm yet: its own name, not that of the arm before.
      const named = text === armText ? facts?.name : /^name\s*:\s*["']?([\w.-]+)/m.exec(text)?.[1];
      const name = `${named ?? "arm"}.yaml`;
      const link = element("a", { href: URL.createObjectURL(new Blob([text])), download: name });
      link.click();
      URL.revokeObjectURL(link.href);
    });
  }

  async take(file: File, base = "", tool = ""): Promise<void> {
    if (file.size > LONGEST) {
      notice(`${file.name} has ${Math.round(file.size / 1e6)} MB: no arm is described by so much text`, true);
      return;
    }
    const { app } = this;
    const number = app.announce();
    const isLate = (): boolean => {
      if (!app.isLatest(number)) notice(`${file.name} is not taken: something else was chosen or typed since`, true);
      return !app.isLatest(number);
    };
    const text = await file.text();
    if (isLate()) return;
    const isImported = isOther(text);
    if (!isImported) {
      const why = whyNone(text);
      if (why) notice(`${file.name} is ${why}: neither an arm file, nor a URDF, a calibration of a UR arm or OPW parameters`, true);
      else await app.setText(text);
      return;
    }
    const box = byId("remarks");
    const ends = byId("ends");
    ends.replaceChildren();
    const dialog = byId<HTMLDialogElement>("imported");
    try {
      const made = await app.jobs.run<{ armFile: string; remarks: string[] }>({
        kind: "import", text, from: file.name, editor: app.armText, base, tool,
      });
      if (isLate()) return;
      await app.setText(made.armFile);
      box.replaceChildren(element("h3", {}, `${file.name}:`), ...made.remarks.map((remark) => element("p", {}, ofPage(remark))));
      dialog.showModal();
    } catch (error) {
      if (isLate()) return;
      // Other ends of the chain, as options of the command: here a button takes each.
      const options = endsOf(messageOf(error));
      if (options.length === 0) {
        notice(`${file.name}: ${ofPage(messageOf(error))}`, true);
        return;
      }
      box.replaceChildren(element("h3", {}, `${file.name}:`), element("p", {}, ofPage(messageOf(error))));
      ends.append(...options.map(([from, to]) => {
        const words = ["Import", from && `from ${from}`, to && `up to ${to}`].filter(Boolean).join(" ");
        const button = element("button", { type: "button" }, words);
        button.addEventListener("click", () => {
          dialog.close();
          void this.take(file, from, to);
        });
        return button;
      }));
      dialog.showModal();
    }
  }
}

/** True for a description of another kind than an arm file. Words in comments say nothing. */
function isOther(text: string): boolean {
  if (/^\s*</.test(text)) return text.includes("<robot");
  return /^[^#\n]*(?:delta_theta|opw_kinematics_geometric_parameters)|^\s*kinematics\s*:/m.test(text);
}

/** A message in the words of the page, which has no options of the command. */
function ofPage(message: string): string {
  return message
    .replaceAll("the arm of `--nominal`", "the arm in the editor")
    .replaceAll("`--exact-within", "`denhart import --exact-within")
    .replace(/ with --(?:base|tool)(?: and --(?:base|tool))?(?=[:;,]|$)/gm, "")
    .replace(/--base (\S+)/g, "from $1")
    .replace(/--tool (\S+)/g, "up to $1");
}

/** The ends of the chain that a message proposes: base and tool, empty for that of the file. */
function endsOf(message: string): [string, string][] {
  const help = message.split("\nhelp: ")[1] ?? "";
  return [...help.matchAll(/(?:--base ([^\s:;,]+))?\s?(?:--tool ([^\s:;,]+))?/g)]
    .map(([, from = "", to = ""]): [string, string] => [from, to])
    .filter(([from, to]) => from !== "" || to !== "");
}

/** The kind of a text that cannot be an arm file; empty for one that may be, with mistakes or without. */
function whyNone(text: string): string {
  if (/[\0-\x08\x0e-\x1f\ufffd]/.test(text)) return "no text";
  if (text.includes("<") && /^\s*</.test(text)) return "XML without an element <robot>";
  // A table of a spreadsheet, a list of numbers, JSON of something else.
  return /^\s*["']?(?:joints|convention|name|units)["']?\s*:/m.test(text) || /["']joints["']\s*:/.test(text) || text.trim() === "" ? "" : "a text without `joints`";
}
