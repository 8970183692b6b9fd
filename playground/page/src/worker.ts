// The worker: code, reports and imports, one at a time.

import init, * as denhart from "../pkg/denhart_page.js";
import { messageOf } from "./dom";

export type Request =
  | { kind: "messages" | "report" | "code" | "header"; text: string }
  | { kind: "import"; text: string; from: string; editor: string; base: string; tool: string }
  | { kind: "thumbnail"; name: string; dark: boolean }
  | { kind: "file"; name: string }
  | { kind: "presets" | "schema" };

export type Reply = { result: unknown; error?: undefined } | { error: string; result?: undefined };

function answer(request: Request): unknown {
  switch (request.kind) {
    case "messages":
      return JSON.parse(denhart.messages(request.text));
    case "report":
      return denhart.report(request.text);
    case "code":
      return denhart.code(request.text);
    case "header":
      return denhart.header(request.text);
    case "import":
      return JSON.parse(denhart.importText(request.text, request.from, request.editor, request.base, request.tool));
    case "thumbnail":
      return denhart.thumbnail(denhart.presetFile(request.name), request.dark);
    case "file":
      return denhart.presetFile(request.name);
    case "presets":
      return JSON.parse(denhart.presetList());
    case "schema":
      return JSON.parse(denhart.schemaText());
  }
}

let ready: Promise<unknown> | undefined;

self.onmessage = async (event: MessageEvent<Uint8Array | Request>) => {
  if (event.data instanceof Uint8Array) {
    ready = init({ module_or_path: event.data as BufferSource });
    return;
  }
  let reply: Reply;
  try {
    await ready;
    reply = { result: answer(event.data) };
  } catch (error) {
    // A trap leaves the memory of the module as it was in the middle of a call: the worker has to go.
    if (error instanceof WebAssembly.RuntimeError) throw error;
    reply = { error: messageOf(error) };
  }
  self.postMessage(reply);
};
