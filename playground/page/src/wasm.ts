// Opens the WebAssembly that the page carries: base64 of its gzip, in a script element.

import init from "../pkg/denhart_page.js";

/** The bytes of the module. */
export async function wasmBytes(): Promise<Uint8Array> {
  const text = atob(document.getElementById("wasm")?.textContent?.trim() ?? "");
  const packed = new Uint8Array(text.length);
  for (let at = 0; at < text.length; at++) packed[at] = text.charCodeAt(at);
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

export async function openWasm(bytes: Uint8Array): Promise<void> {
  await init({ module_or_path: bytes as BufferSource });
}
