// Small helpers to make and find elements.

type Content = Node | string;

/** An element with attributes and children. Attributes whose value is `false` are left out. */
export function element<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes: Record<string, string | number | boolean> = {},
  ...children: Content[]
): HTMLElementTagNameMap[K] {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (value !== false) made.setAttribute(name, value === true ? "" : String(value));
  }
  made.append(...children);
  return made;
}

/** The element of an id, which the page has. */
export function byId<T extends HTMLElement = HTMLElement>(id: string): T {
  const found = document.getElementById(id);
  if (!found) throw new Error(`the page has no element ${id}`);
  return found as T;
}

/** A line that is shown for some seconds. */
export function notice(text: string, isMistake = false): void {
  const box = byId("notices");
  // A few lines, none of them twice: they lie over the page.
  for (const old of [...box.children]) if (old.textContent === text) old.remove();
  while (box.children.length > 1) box.firstChild!.remove();
  const line = element("div", { class: isMistake ? "notice mistake" : "notice", role: isMistake ? "alert" : "status" }, text);
  line.addEventListener("click", () => line.remove());
  box.append(line);
  setTimeout(() => line.remove(), isMistake ? 9000 : 4000);
}

/** Copies text, and says so. */
export async function copy(text: string, what: string, remark = ""): Promise<void> {
  try {
    await navigator.clipboard.writeText(text);
  } catch {
    // Pages opened from a file may have no clipboard.
    const area = element("textarea", { style: "position:fixed;opacity:0" });
    area.value = text;
    document.body.append(area);
    area.select();
    document.execCommand("copy");
    area.remove();
  }
  notice(`${what} copied${remark}`, remark !== "");
}

/** The message of anything that was thrown. */
export function messageOf(error: unknown): string {
  return error instanceof Error ? error.message : String(error);
}
