// A link that holds arm, joints and target: compressed, in the fragment, which no server sees.

import type { App, Snapshot } from "./app";
import { byId, copy } from "./dom";

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

/** The state of a fragment; none if it is not one of this page's. */
export async function stateOf(fragment: string): Promise<Partial<Snapshot> | undefined> {
  if (!fragment.startsWith(HEAD)) return undefined;
  const text = new TextDecoder().decode(await through(toBytes(fragment.slice(HEAD.length)), new DecompressionStream("deflate-raw")));
  const state = JSON.parse(text) as Record<string, unknown>;
  const numbers = (value: unknown): number[] | undefined =>
    Array.isArray(value) && value.every((one) => typeof one === "number") ? (value as number[]) : undefined;
  if (typeof state.text !== "string") return undefined;
  const made: Partial<Snapshot> = { text: state.text };
  const [q, target, given] = [numbers(state.q), numbers(state.target), numbers(state.given)];
  if (q) made.q = q;
  if (target) made.target = target;
  if (given) made.given = given;
  if (typeof state.angle === "number") made.angle = state.angle;
  return made;
}

export function offerLink(app: App): void {
  byId("share").addEventListener("click", () => {
    void fragmentOf(app.snapshot()).then((fragment) => {
      history.replaceState(history.state, "", fragment);
      const isOld = app.text !== app.armText;
      return copy(location.href, "link", isOld ? ": it holds the last arm file without mistakes, not what is typed" : "");
    });
  });
}
