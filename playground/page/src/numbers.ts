// The numbers that WebAssembly gives, as playground/wasm/src/numbers.rs lays them out.

/** A pose: the rotation by rows, then the point. */
export type Pose = number[];
export type Point = [number, number, number];

/** An arm in one posture. */
export interface Figure {
  tool: Pose;
  /** A bit for each joint outside its limits. */
  outside: number;
  /** The least margin to a singularity; not a number where the arm has none. */
  margin: number;
  joints: { point: Point; axis: Point }[];
  links: Point[][];
}

export const EXACT = 1;
export const BOUNDARY = 2;
export const FREE = 4;
export const APPROXIMATE = 8;
export const OUT_OF_LIMITS = 16;

export interface Solution {
  flags: number;
  /** A bit for each joint whose value the target leaves open. */
  free: number;
  residual: [number, number];
  q: number[];
  figure: Figure;
}

export interface Answer {
  status: "reached" | "missed" | "no target";
  gap: number;
  deviation: number;
  complete: boolean;
  solutions: Solution[];
}

class Reader {
  private at = 0;
  constructor(private readonly numbers: Float64Array) {}
  next(): number {
    return this.numbers[this.at++] ?? NaN;
  }
  take(count: number): number[] {
    const part = Array.from(this.numbers.subarray(this.at, this.at + count));
    this.at += count;
    return part;
  }
  point(): Point {
    return [this.next(), this.next(), this.next()];
  }
  figure(joints: number): Figure {
    const tool = this.take(12);
    const outside = this.next();
    const margin = this.next();
    const figure: Figure = { tool, outside, margin, joints: [], links: [] };
    for (let joint = 0; joint < joints; joint++) figure.joints.push({ point: this.point(), axis: this.point() });
    for (let link = 0; link <= joints; link++) {
      const corners: Point[] = [];
      for (let left = this.next(); left > 0; left--) corners.push(this.point());
      figure.links.push(corners);
    }
    return figure;
  }
}

export function figureOf(numbers: Float64Array, joints: number): Figure {
  return new Reader(numbers).figure(joints);
}

export function answerOf(numbers: Float64Array, joints: number): Answer {
  const reader = new Reader(numbers);
  const status = (["reached", "missed", "no target"] as const)[reader.next()] ?? "no target";
  const [gap = NaN, deviation = NaN, complete = 1, count = 0] = reader.take(4);
  const solutions: Solution[] = [];
  for (let left = count; left > 0; left--) {
    const [flags = 0, free = 0, position = NaN, orientation = NaN] = reader.take(4);
    const q = reader.take(joints);
    reader.next();
    solutions.push({ flags, free, residual: [position, orientation], q, figure: reader.figure(joints) });
  }
  return { status, gap, deviation, complete: complete === 1, solutions };
}

/** The joints whose bits are set, from 0. */
export function bits(mask: number, joints: number): number[] {
  return Array.from({ length: joints }, (_, joint) => joint).filter((joint) => (mask >> joint) & 1);
}

/** A number for people: at most so many digits behind the point, no zeros at the end. */
export function short(value: number, digits = 4): string {
  if (!Number.isFinite(value)) return Number.isNaN(value) ? "?" : value > 0 ? "∞" : "-∞";
  if (value !== 0 && (Math.abs(value) >= 1e7 || (digits > 0 && Math.abs(value) < 10 ** -digits / 2))) {
    return Math.abs(value) < 1e-9 ? "0" : value.toExponential(2);
  }
  const fixed = value.toFixed(digits);
  const text = fixed.includes(".") ? fixed.replace(/\.?0+$/, "") : fixed;
  return text === "-0" ? "0" : text;
}

const DEGREE = Math.PI / 180;
export const degrees = (rad: number): number => rad / DEGREE;
export const radians = (deg: number): number => deg * DEGREE;

/** Roll, pitch and yaw of a pose: R = Rz(yaw) Ry(pitch) Rx(roll). */
export function rpy(pose: Pose): Point {
  const [r00 = 1, r01 = 0, , r10 = 0, r11 = 1, , r20 = 0, r21 = 0, r22 = 1] = pose;
  const cos = Math.hypot(r00, r10);
  if (cos < 1e-12) return [0, Math.atan2(-r20, cos), Math.atan2(-r01, r11)];
  return [Math.atan2(r21, r22), Math.atan2(-r20, cos), Math.atan2(r10, r00)];
}

/** The pose of a point and roll, pitch, yaw. */
export function poseOf([x, y, z]: Point, [roll, pitch, yaw]: Point): Pose {
  const [sr, cr, sp, cp, sy, cy] = [
    Math.sin(roll), Math.cos(roll), Math.sin(pitch), Math.cos(pitch), Math.sin(yaw), Math.cos(yaw),
  ];
  return [
    cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr,
    sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr,
    -sp, cp * sr, cp * cr, x, y, z,
  ];
}

export function pointOf(pose: Pose): Point {
  return [pose[9] ?? NaN, pose[10] ?? NaN, pose[11] ?? NaN];
}
