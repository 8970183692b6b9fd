// The width of the arm file: dragged, or changed by arrow keys.

import { byId } from "./dom";

/** Widths of the arm file, px: the least, and what it leaves to the others. */
const [LEAST, OTHERS] = [240, 700];

export function listenToSplitter(): void {
  const bar = byId("splitter");
  const table = byId("table");
  const most = (): number => Math.max(innerWidth - OTHERS, LEAST);
  const put = (width: number): void => {
    document.body.style.setProperty("--table", `${Math.round(Math.min(Math.max(width, LEAST), most()))}px`);
  };
  new ResizeObserver(() => {
    bar.setAttribute("aria-valuemin", String(LEAST));
    bar.setAttribute("aria-valuemax", String(most()));
    bar.setAttribute("aria-valuenow", String(Math.round(table.getBoundingClientRect().width)));
  }).observe(table);
  bar.addEventListener("pointerdown", (event) => {
    bar.setPointerCapture(event.pointerId);
    event.preventDefault();
  });
  bar.addEventListener("pointermove", (event) => {
    if (bar.hasPointerCapture(event.pointerId)) put(event.clientX);
  });
  bar.addEventListener("keydown", (event) => {
    const step = { ArrowLeft: -20, ArrowRight: 20 }[event.key];
    if (step) put(table.getBoundingClientRect().width + step);
  });
}
