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
      const { text, armText, facts } = this.app;
      // A text with mistakes is no arm yet: its own name, not that of the arm before.
      const named = text === armText ? facts?.name : /^name\s*:\s*["']?([\w.-]+)/m.exec(text)?.[1];
      const name = `${named ?? "arm"}.yaml`;
      const link = element("a", { href: URL.createObjectURL(new Blob([text])), download: name });
      link.click();
      URL.revokeObjectURL(link.href);
    });
  }

  async take(file: File): Promise<void> {
    if (file.size > LONGEST) {
      notice(`${file.name} has ${Math.round(file.size / 1e6)} MB: no arm is described by so much text`, true);
      return;
    }
    const text = await file.text();
    const isImported = /<robot|delta_theta|opw_kinematics_geometric_parameters|^\s*kinematics\s*:/m.test(text);
    if (!isImported) {
      if (text.includes("<")) notice(`${file.name} is no URDF: it has no element <robot>`, true);
      else await this.app.setText(text);
      return;
    }
    try {
      const made = await this.app.jobs.run<{ armFile: string; remarks: string[] }>({
        kind: "import", text, from: file.name, editor: this.app.armText,
      });
      await this.app.setText(made.armFile);
      const box = byId("remarks");
      box.replaceChildren(element("h3", {}, `${file.name}:`), ...made.remarks.map((remark) => element("p", {}, remark)));
      byId<HTMLDialogElement>("imported").showModal();
    } catch (error) {
      notice(`${file.name}: ${messageOf(error)}`, true);
    }
  }
}
