// The width of the arm file: dragged, or changed by arrow keys.

import { byId } from "./dom";

export function listenToSplitter(): void {
  const bar = byId("splitter");
  const table = byId("table");
  const put = (width: number): void => {
    document.body.style.setProperty("--table", `${Math.round(Math.min(Math.max(width, 240), innerWidth - 700))}px`);
  };
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
