// Fields for a number: steps of the arrow keys, and the value from before where no number is typed.

import { notice } from "./dom";

interface Use {
  /** The step of the arrow keys; ten times as much with Shift. */
  step: () => number;
  /** The largest size of a number that is taken. */
  most: () => number;
  /** Takes a number. */
  take: (value: number, byArrow: boolean) => void;
  /** Shows the value that counts. */
  restore: () => void;
}

/** Listens to a field. */
export function listenToField(field: HTMLInputElement, { step, most, take, restore }: Use): void {
  const typed = (): void => {
    const value = field.value.trim() === "" ? NaN : Number(field.value);
    if (Number.isFinite(value) && Math.abs(value) <= most()) {
      take(value, false);
      return;
    }
    const name = field.getAttribute("aria-label") ?? "";
    const why = Number.isFinite(value) ? `${field.value} is too large` : "this is no number";
    restore();
    notice(`${name}: ${why}; it stays at ${field.value}`, true);
  };
  field.addEventListener("change", typed);
  // A browser may leave out a comma that is typed, and take 3,5 for 35.
  field.addEventListener("beforeinput", (event) => {
    if (!event.data?.includes(",")) return;
    event.preventDefault();
    notice(`${field.getAttribute("aria-label") ?? ""}: a number has a point, not a comma: 3.5`, true);
  });
  field.addEventListener("keydown", (event) => {
    const sign = { ArrowUp: 1, ArrowDown: -1 }[event.key];
    if (sign) {
      event.preventDefault();
      const value = (Number(field.value) || 0) + sign * step() * (event.shiftKey ? 10 : 1);
      if (Math.abs(value) > most()) return;
      field.value = String(Number(value.toFixed(9)));
      take(Number(field.value), true);
    } else if (event.key === "Enter" && (field.value === "" || field.validity.badInput)) {
      // Letters leave the value as it was for the browser: no change is told.
      event.preventDefault();
      typed();
    }
  });
}

/** 1, 2 or 5 times a power of ten, at most `length`. */
export function roundStep(length: number): number {
  const power = 10 ** Math.floor(Math.log10(length));
  return ([5, 2].find((step) => step * power <= length) ?? 1) * power;
}
