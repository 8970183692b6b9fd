// Words over the picture: elements at projected points, moved apart where they would cover each other.

import * as THREE from "three";
import { element } from "./dom";
import type { Point } from "./numbers";

export interface Label {
  point: Point;
  /** Places to take where the first one is on the handles of the target. */
  others?: Point[];
  text: string;
  kind: "ghost" | "joint" | "frame" | "measure" | "axes" | "miss";
  color?: string;
  /** Of words on that color. */
  ink?: string;
  title?: string;
  isStrong?: boolean;
  click?: () => void;
}

const at = new THREE.Vector3();
const aim = new THREE.Vector3();
/** The handles of the target lie within so many px. */
const HANDLES = 84;

export class Labels {
  private labels: Label[] = [];
  private readonly elements: HTMLElement[] = [];
  /** The target, whose handles stay free. */
  target: Point | undefined;

  constructor(private readonly box: HTMLElement) {}

  set(labels: Label[]): void {
    this.labels = labels;
  }

  /** Puts every label to its place. */
  place(camera: THREE.Camera, width: number, height: number): void {
    const taken: [number, number, number, number][] = [];
    this.labels.forEach((label, index) => {
      const shown = (this.elements[index] ??= this.box.appendChild(element("span")));
      const { target } = this;
      const places = [label.point, ...(label.others ?? [])];
      const isFree = (place: Point): boolean => {
        if (!target) return true;
        const [a, b] = [at.set(...place).project(camera), aim.set(...target).project(camera)];
        return Math.hypot((a.x - b.x) * width, (a.y - b.y) * height) / 2 > HANDLES;
      };
      const isGhost = label.kind === "ghost";
      const place = (isGhost && places.find(isFree)) || label.point;
      at.set(...place).project(camera);
      const hidden = at.z > 1 || Math.abs(at.x) > 1.05 || Math.abs(at.y) > 1.05;
      shown.hidden = hidden;
      if (hidden) return;
      if (shown.textContent !== label.text) shown.textContent = label.text;
      const kind = `label ${label.kind}${label.isStrong ? " strong" : ""}`;
      if (shown.className !== kind) shown.className = kind;
      shown.title = label.title ?? "";
      shown.style.setProperty("--color", label.color ?? "");
      shown.style.setProperty("--on-color", label.ink ?? "");
      shown.onclick = label.click ?? null;
      // Widths are guessed: asking for them would lay the page out once for each label.
      // Long words wrap at the width of the style sheet.
      const [long, most] = [label.text.length * 7 + 10, label.kind === "axes" ? Math.min(340, width - 4) : Infinity];
      const [w, h] = [Math.min(long, most), 18 * Math.max(Math.ceil(long / most), 1)];
      let [x, y] = [((at.x + 1) / 2) * width + 8, ((1 - at.y) / 2) * height - h - 4];
      x = Math.max(Math.min(x, width - w - 2), 2);
      y = Math.min(Math.max(y, 2), height - h - 2);
      for (let tries = 0; tries < 12; tries++) {
        const over = taken.find(([left, top, right, bottom]) => x < right && x + w > left && y < bottom && y + h > top);
        if (!over) break;
        y = over[3] + 1;
        // Below the picture nothing is seen.
        if (y > height - h - 2) [x, y] = [over[2] + 1, over[1]];
      }
      taken.push([x, y, x + w, y + h]);
      shown.style.transform = `translate(${x.toFixed(1)}px, ${y.toFixed(1)}px)`;
    });
    for (const left of this.elements.slice(this.labels.length)) left.hidden = true;
  }
}
