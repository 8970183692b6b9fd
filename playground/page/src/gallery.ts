// The arms of specs/: a gallery to search, with the pictures of `denhart draw`.

import type { App } from "./app";
import { isDark } from "./colors";
import { byId, element, messageOf, notice } from "./dom";
import type { Preset } from "./facts";

export class Gallery {
  private readonly dialog = byId<HTMLDialogElement>("gallery");
  private readonly search = byId<HTMLInputElement>("gallery-search");
  private presets: Preset[] = [];
  private readonly pictures = new IntersectionObserver((entries) => {
    for (const entry of entries) if (entry.isIntersecting) void this.picture(entry.target as HTMLElement);
  });

  constructor(private readonly app: App) {
    byId("presets").addEventListener("click", () => void this.open());
    byId("gallery-close").addEventListener("click", () => this.dialog.close());
    this.search.addEventListener("input", () => this.filter());
    // Enter takes the first arm that is left.
    this.search.addEventListener("keydown", (event) => {
      if (event.key !== "Enter") return;
      event.preventDefault();
      byId("gallery-list").querySelector<HTMLButtonElement>("button:not([hidden])")?.click();
    });
  }

  async open(): Promise<void> {
    this.dialog.showModal();
    this.search.value = "";
    this.search.focus();
    if (this.presets.length === 0) {
      this.presets = await this.app.jobs.run<Preset[]>({ kind: "presets" });
      byId("gallery-list").replaceChildren(...this.presets.map((preset) => this.card(preset)));
    }
    this.filter();
  }

  private card(preset: Preset): HTMLElement {
    const card = element(
      "button",
      { type: "button", class: "card", "data-name": preset.name },
      element("span", { class: "thumbnail" }),
      element("strong", {}, preset.name),
      element("span", { class: "kinds" }, preset.joints ?? ""),
      element("small", {}, preset.source),
    );
    card.addEventListener("click", () => void this.choose(preset.name));
    this.pictures.observe(card);
    return card;
  }

  private async choose(name: string): Promise<void> {
    const { app } = this;
    this.dialog.close();
    const number = app.announce();
    try {
      const text = await app.jobs.run<string>({ kind: "file", name });
      if (app.isLatest(number)) {
        await app.setText(text);
        return;
      }
    } catch (error) {
      if (app.isLatest(number)) {
        notice(messageOf(error), true);
        return;
      }
    }
    notice(`${name} is not taken: something else was chosen or typed since`, true);
  }

  private filter(): void {
    const words = this.search.value.toLowerCase().split(/\s+/).filter(Boolean);
    let left = 0;
    for (const card of byId("gallery-list").querySelectorAll<HTMLElement>(".card")) {
      card.hidden = !words.every((word) => card.textContent!.toLowerCase().includes(word));
      if (!card.hidden) left++;
    }
    byId("gallery-count").textContent = `${left} arm${left === 1 ? "" : "s"}`;
  }

  private async picture(card: HTMLElement): Promise<void> {
    this.pictures.unobserve(card);
    const name = card.dataset.name ?? "";
    try {
      const svg = await this.app.jobs.run<string>({ kind: "thumbnail", name, dark: isDark() }, `thumbnail ${name}`);
      const image = element("img", { alt: "", src: `data:image/svg+xml,${encodeURIComponent(svg)}` });
      card.querySelector(".thumbnail")!.replaceChildren(image);
    } catch {
      // A card without a picture still has its name.
    }
  }
}
