// Facts of an arm beside its posture: playground/wasm/src/facts.rs.

export interface JointFacts {
  name: string;
  turns: boolean;
  low: number | null;
  high: number | null;
  /** Its row of the table, from 0. */
  row: number;
}

export interface GivenFacts {
  name: string;
  slides: boolean;
  range: [number, number];
}

export interface Facts {
  name: string;
  unit: string;
  joints: JointFacts[];
  rows: { joint: number | null; fixed: boolean; numbers: [number, number, number, number] }[];
  task: string | null;
  column: number | null;
  noInverse: string | null;
  given: GivenFacts[];
  maxSolutions: number | null;
  reach: number | null;
  /** The axes that decide the inverse, in words. */
  axes: string;
  planar: boolean;
  pulses: boolean;
}

export interface Message {
  severity: "error" | "warning";
  message: string;
  line?: number;
  column?: number;
  end_column?: number;
  help?: string;
}

export interface Preset {
  name: string;
  source: string;
  joints: string | null;
}

/** Axes whose relation the inverse rests on: draw/src/deciding.rs. */
export interface DecidingAxes {
  joints: number[];
  lines: [[number, number, number], [number, number, number]][];
  /** Where they meet. */
  point: [number, number, number] | null;
  words: string;
}

export interface TableParts {
  frames: { name: string; pose: number[] }[];
  measures: { name: string; value: number; from: [number, number, number]; to: [number, number, number] }[];
  axes: DecidingAxes[];
  far: string[];
}
