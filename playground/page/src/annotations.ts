// Drawn on demand: frames of the table, its lengths as dimension lines, and the way to a target that is missed.

import * as THREE from "three";
import { color, css } from "./colors";
import type { TableParts } from "./facts";
import type { Label } from "./labels";
import { short, type Point } from "./numbers";

interface Wanted {
  frames: boolean;
  dimensions: boolean;
  /** The number of the row that is marked, from 1. */
  marked: number | undefined;
  size: number;
  unit: string;
}

export class Annotations {
  private readonly frames: THREE.LineSegments;
  private readonly measures: THREE.LineSegments;
  private readonly gap: THREE.Line;

  constructor(scene: THREE.Scene) {
    this.frames = new THREE.LineSegments(new THREE.BufferGeometry(), new THREE.LineBasicMaterial({ vertexColors: true, depthTest: false }));
    this.measures = new THREE.LineSegments(new THREE.BufferGeometry(), new THREE.LineBasicMaterial({ vertexColors: true, depthTest: false }));
    this.gap = new THREE.Line(new THREE.BufferGeometry(), new THREE.LineDashedMaterial({ depthTest: false }));
    for (const lines of [this.frames, this.measures, this.gap]) {
      lines.frustumCulled = false;
      lines.renderOrder = 3;
      scene.add(lines);
    }
  }

  /** Draws frames and lengths, and returns their names. */
  show(table: TableParts | undefined, wanted: Wanted): Label[] {
    const labels: Label[] = [];
    const [framePoints, frameColors]: [number[], number[]] = [[], []];
    if (table && wanted.frames) {
      for (const { name, pose } of table.frames) {
        const origin = pose.slice(9, 12) as Point;
        (["x", "y", "z"] as const).forEach((axis, column) => {
          const end = origin.map((value, row) => value + 0.16 * wanted.size * (pose[3 * row + column] ?? 0));
          framePoints.push(...origin, ...end);
          frameColors.push(...twice(color(axis)));
        });
        labels.push({ point: origin, text: `frame ${name}`, kind: "frame" });
      }
    }
    fill(this.frames, framePoints, frameColors);
    const [points, colors]: [number[], number[]] = [[], []];
    for (const { name, value, from, to } of table?.measures ?? []) {
      const isMarked = wanted.marked !== undefined && (name === `a${wanted.marked}` || name === `d${wanted.marked}`);
      if (!wanted.dimensions && !isMarked) continue;
      const of = isMarked ? color("marked") : color("measure");
      points.push(...from, ...to);
      colors.push(...twice(of));
      const middle = from.map((start, axis) => (start + (to[axis] ?? 0)) / 2) as Point;
      labels.push({ point: middle, text: `${name} ${short(value, 5)} ${wanted.unit}`, kind: "measure", color: css(of), isStrong: isMarked });
    }
    fill(this.measures, points, colors);
    return labels;
  }

  /** The way from the tool to a target that is missed. */
  missed(ends: [Point, Point] | undefined): void {
    this.gap.visible = ends !== undefined;
    if (!ends) return;
    const [from, to] = ends;
    const length = Math.hypot(...from.map((value, axis) => value - to[axis]!));
    const material = this.gap.material as THREE.LineDashedMaterial;
    material.color.set(color("target"));
    material.dashSize = material.gapSize = Math.max(length / 24, 1e-9);
    this.gap.geometry.setFromPoints([new THREE.Vector3(...from), new THREE.Vector3(...to)]);
    this.gap.computeLineDistances();
  }
}

/** The color of both ends of a line. */
function twice(hex: number): number[] {
  const rgb = new THREE.Color(hex).toArray();
  return [...rgb, ...rgb];
}

function fill(lines: THREE.LineSegments, points: number[], colors: number[]): void {
  lines.visible = points.length > 0;
  if (!lines.visible) return;
  lines.geometry.dispose();
  lines.geometry = new THREE.BufferGeometry();
  lines.geometry.setAttribute("position", new THREE.Float32BufferAttribute(points, 3));
  lines.geometry.setAttribute("color", new THREE.Float32BufferAttribute(colors, 3));
}
