// Starts the page.

import { presetFile, version } from "../pkg/denhart_page.js";
import { Answers } from "./answers";
import { App, type Snapshot } from "./app";
import { byId, messageOf, notice } from "./dom";
import { drafted, keepDraft } from "./draft";
import { Editor } from "./editor";
import { Files } from "./files";
import { FlatView } from "./flat";
import { Follower } from "./follower";
import { Gallery } from "./gallery";
import { Jobs } from "./jobs";
import { listenToKeys } from "./keys";
import { Motors } from "./motors";
import { Results } from "./results";
import { follow, given, isServed } from "./served";
import { offerLink, stateOf } from "./share";
import { listenForRemarks } from "./remarks";
import { Sliders } from "./sliders";
import { listenToSplitter } from "./splitter";
import { View } from "./view";
import { openWasm, wasmBytes } from "./wasm";

/** The arm of a first visit. */
const FIRST = "ur5";

/** The picture in space, or the flat one where the browser has no WebGL. */
function picture(app: App): View | undefined {
  const box = byId("view");
  try {
    return new View(app, box, byId("labels"));
  } catch {
    new FlatView(app, box);
    return undefined;
  }
}

function switches(app: App, view: View | undefined): void {
  for (const key of ["ghosts", "frames", "dimensions", "axes", "names"] as const) {
    const box = byId<HTMLInputElement>(`show-${key}`);
    box.checked = app.shown[key];
    box.addEventListener("change", () => {
      app.shown[key] = box.checked;
      app.emit("shown");
    });
  }
  const tell = (): void => {
    byId("axes-switch").title = `The axes that decide the inverse (A): ${app.facts?.axes ?? ""}`;
  };
  app.listen((change) => change === "arm" && tell());
  tell();
  for (const mode of ["translate", "rotate"] as const) {
    byId(`mode-${mode}`).addEventListener("click", () => {
      view?.setMode(mode);
      for (const one of ["translate", "rotate"]) byId(`mode-${one}`).setAttribute("aria-pressed", String(one === mode));
    });
  }
  byId("frame").addEventListener("click", () => view?.frame());
  byId("zero").addEventListener("click", () => {
    app.moveTo(app.q.map(() => 0));
    app.remember();
  });
  const [undo, redo] = [byId<HTMLButtonElement>("undo"), byId<HTMLButtonElement>("redo")];
  undo.addEventListener("click", () => app.undo());
  redo.addEventListener("click", () => app.redo());
  app.listen((change) => {
    if (change !== "kept" && change !== "text") return;
    undo.disabled = !app.canUndo;
    redo.disabled = !app.canRedo;
  });
  byId("help").addEventListener("click", () => byId<HTMLDialogElement>("helping").showModal());
  // On a phone one part is seen at a time.
  for (const part of ["table", "arm", "results"]) {
    byId(`go-${part}`).addEventListener("click", () => {
      document.body.dataset.part = part;
      for (const one of ["table", "arm", "results"]) byId(`go-${one}`).setAttribute("aria-pressed", String(one === part));
    });
  }
}

/** The state of the link, unless it holds none. */
async function linked(): Promise<Partial<Snapshot> | undefined> {
  if (isServed()) {
    if (!location.hash) return undefined;
    history.replaceState(history.state, "", location.pathname + location.search);
    notice("This page shows the file of the command: the arm of the link is left out. Any other page of denhart opens it.", true);
    return undefined;
  }
  try {
    return await stateOf(location.hash);
  } catch (error) {
    notice(`this link cannot be opened: ${messageOf(error)}`, true);
    return undefined;
  }
}

/** A trap leaves the module's memory in the middle of a call: only a new page is sure to be right. */
addEventListener("error", (event) => {
  if (event.error instanceof WebAssembly.RuntimeError) {
    notice("The generator failed here, which is a defect of denhart. Load the page again; a link keeps the arm.", true);
  }
});

/** The browser has drawn. */
const drawn = (): Promise<void> => new Promise((done) => requestAnimationFrame(() => setTimeout(done)));

async function start(): Promise<void> {
  const bytes = await wasmBytes();
  performance.mark("unpacked");
  await openWasm(bytes);
  performance.mark("opened");
  const jobs = new Jobs(bytes);
  const app = new App(jobs);
  const view = picture(app);
  new Sliders(app);
  new Answers(app);
  new Motors(app);
  listenForRemarks(app);
  new Follower(app);
  byId("version").textContent = version();
  // For the tests in a browser, and for the curious.
  Object.assign(window, { denhart: { app, view } });

  const here = given();
  app.file = here?.text;
  const draft = drafted(here?.text);
  const link = draft && !isServed() ? undefined : await linked();
  const text = draft?.kept.text ?? link?.text ?? here?.text ?? presetFile(FIRST);
  // Arms that were shown before are shown at once; any other text is read by the worker first, which may take its time.
  if (draft) app.begin(draft.kept.arm, draft.kept);
  else if (!link && !here) app.begin(text);
  document.body.classList.add("is-drawn");
  await drawn();
  performance.mark("first picture");

  // Behind the picture comes what needs the worker.
  new Results(app);
  new Editor(app, jobs.run<object>({ kind: "schema" }));
  new Gallery(app);
  new Files(app);
  offerLink(app);
  keepDraft(app);
  switches(app, view);
  listenToKeys(app);
  listenToSplitter();
  await app.setText(text, link);
  if (draft?.isOld && here) {
    await app.setText(here.text);
    notice(`${here.name} has changed: Undo comes back to what was typed before`, true);
  }
  addEventListener("hashchange", () => {
    void linked().then((next) => {
      if (next?.text !== undefined) void app.setText(next.text, next);
    });
  });
  if (here?.follow) follow(app, here);
  document.body.classList.add("is-ready");
}

start().catch((error: unknown) => {
  byId("starting").textContent = `The page cannot start here: ${messageOf(error)}`;
});
