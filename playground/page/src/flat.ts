// The picture of denhart-draw, where the browser has no WebGL.

import type { App } from "./app";
import { isDark, onThemeChange } from "./colors";
import { element, messageOf } from "./dom";

export class FlatView {
  private isDue = false;
  private readonly picture = element("div", { class: "flat" });

  constructor(private readonly app: App, private readonly box: HTMLElement) {
    box.prepend(this.picture);
    document.body.classList.add("is-flat");
    app.listen((change) => {
      if (change !== "text" && change !== "messages" && change !== "marked" && change !== "kept" && change !== "file") this.draw();
    });
    onThemeChange(() => this.draw());
    new ResizeObserver(() => this.draw()).observe(box);
  }

  private draw(): void {
    if (this.isDue) return;
    this.isDue = true;
    requestAnimationFrame(() => {
      this.isDue = false;
      this.show();
    });
  }

  private show(): void {
    const { app } = this;
    if (!app.arm || !app.facts) return;
    const target = app.shown.ghosts && app.facts.task ? app.target : [];
    const [width, height] = [Math.max(this.box.clientWidth, 200), Math.max(this.box.clientHeight - 60, 200)];
    try {
      this.picture.innerHTML = app.arm.svg(
        Float64Array.from(app.q), Float64Array.from(target), app.angle, Float64Array.from(app.given),
        app.shown.frames, app.shown.dimensions, app.shown.axes, isDark(), width, height,
      );
    } catch (error) {
      this.picture.textContent = messageOf(error);
    }
  }
}
