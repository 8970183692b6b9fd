// A link that holds arm, joints and target: compressed, in the fragment, which no server sees.

import type { App, Snapshot } from "./app";
import { byId, copy } from "./dom";
import { isServed } from "./served";

const HEAD = "#v1.";
/** A fragment that unpacks to more is none of this page's. */
const LONGEST = 400_000;

async function through(bytes: Uint8Array, stream: GenericTransformStream): Promise<Uint8Array> {
  const reader = new Blob([bytes as BlobPart]).stream().pipeThrough(stream as ReadableWritablePair<Uint8Array, Uint8Array<ArrayBuffer>>).getReader();
  const parts: Uint8Array[] = [];
  let size = 0;
  for (;;) {
    const { done, value } = await reader.read();
    if (done) break;
    size += value.length;
    if (size > LONGEST) throw new Error("the link holds too much");
    parts.push(value);
  }
  return new Uint8Array(await new Blob(parts as BlobPart[]).arrayBuffer());
}

const toText = (bytes: Uint8Array): string =>
  btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join("")).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
const toBytes = (text: string): Uint8Array =>
  Uint8Array.from(atob(text.replaceAll("-", "+").replaceAll("_", "/")), (letter) => letter.charCodeAt(0));

/** The fragment of a state. */
export async function fragmentOf(state: Snapshot): Promise<string> {
  const packed = await through(new TextEncoder().encode(JSON.stringify(state)), new CompressionStream("deflate-raw"));
  return HEAD + toText(packed);
}

/** What a link holds. Throws where it was cut off on its way. */
async function unpacked(packed: string): Promise<Record<string, unknown>> {
  try {
    const text = new TextDecoder().decode(await through(toBytes(packed), new DecompressionStream("deflate-raw")));
    return Object(JSON.parse(text)) as Record<string, unknown>;
  } catch {
    throw new Error("it is damaged, or not whole");
  }
}

/** The state of a fragment; none if it is not one of this page's. Throws for a link that holds no arm. */
export async function stateOf(fragment: string): Promise<Partial<Snapshot> | undefined> {
  if (!/^#v\d+\./.test(fragment)) return undefined;
  if (!fragment.startsWith(HEAD)) throw new Error("another version of this page has made it");
  const state = await unpacked(fragment.slice(HEAD.length));
  const numbers = (value: unknown): number[] | undefined =>
    Array.isArray(value) && value.every((one) => typeof one === "number") ? (value as number[]) : undefined;
  if (typeof state.text !== "string") throw new Error("it holds no arm file");
  const made: Partial<Snapshot> = { text: state.text };
  const [q, target, given] = [numbers(state.q), numbers(state.target), numbers(state.given)];
  if (q) made.q = q;
  if (target) made.target = target;
  if (given) made.given = given;
  if (typeof state.angle === "number") made.angle = state.angle;
  return made;
}

export function offerLink(app: App): void {
  const offer = async (): Promise<void> => {
    await app.settle();
    const fragment = await fragmentOf(app.snapshot());
    const old = app.text === app.armText ? "" : ": it holds the last arm file without mistakes, not what is typed";
    if (isServed()) {
      // The address has the token of the command, which is for nobody else.
      const where = "\nThe command serves this page to this computer alone. `denhart view --export FILE.html` makes a page for others: put what was copied behind its address.";
      await copy(fragment, "end of a link", old + where);
      return;
    }
    history.replaceState(history.state, "", fragment);
    const link = new URL(location.href);
    link.search = "";
    await copy(link.href, "link", old);
  };
  byId("share").addEventListener("click", () => void offer());
}
