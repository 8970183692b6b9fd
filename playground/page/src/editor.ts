// The arm file: an editor with its mistakes in place, completion, and the rows of the table to point at.

import { autocompletion, closeBrackets, closeBracketsKeymap, completionKeymap } from "@codemirror/autocomplete";
import { defaultKeymap, history, historyKeymap, indentWithTab } from "@codemirror/commands";
import { yaml } from "@codemirror/lang-yaml";
import { bracketMatching, syntaxTree } from "@codemirror/language";
import { lintGutter, lintKeymap, setDiagnostics, type Diagnostic } from "@codemirror/lint";
import { Compartment, EditorState, StateEffect, StateField, type Extension, type Text } from "@codemirror/state";
import { Decoration, EditorView, highlightActiveLine, hoverTooltip, keymap, lineNumbers, type DecorationSet } from "@codemirror/view";
import type { App } from "./app";
import { completeFrom, describeFrom } from "./completion";
import { byId, element } from "./dom";
import type { Message } from "./facts";
import { highlighting } from "./highlight";
import { isTooDeep } from "./nesting";

const markLines = StateEffect.define<{ from: number; to: number } | undefined>();

/** The lines of the marked row. */
const marked = StateField.define<DecorationSet>({
  create: () => Decoration.none,
  update(marks, transaction) {
    for (const effect of transaction.effects) {
      if (!effect.is(markLines)) continue;
      if (!effect.value) return Decoration.none;
      const lines = [];
      for (let number = effect.value.from; number <= effect.value.to && number <= transaction.state.doc.lines; number++) {
        lines.push(Decoration.line({ class: "marked-row" }).range(transaction.state.doc.line(number).from));
      }
      return Decoration.set(lines);
    }
    return marks.map(transaction.changes);
  },
  provide: (field) => EditorView.decorations.from(field),
});

const language = new Compartment();

const isPlain = (state: EditorState): boolean => Array.isArray(language.get(state));

/** A text that nests too deep has no language: its tree would be walked by recursion. */
const loseLanguage = EditorState.transactionExtender.of(({ docChanged, newDoc, startState }) =>
  docChanged && !isPlain(startState) && isTooDeep(newDoc.toString()) ? { effects: language.reconfigure([]) } : null);

/** Typing rests so long before the text is checked, ms. */
const REST = 120;

export class Editor {
  readonly view: EditorView;
  private timer = 0;
  private readonly extensions: Extension[];

  constructor(private readonly app: App, schema: Promise<object>) {
    let complete: ReturnType<typeof completeFrom> | undefined;
    let describe: ReturnType<typeof describeFrom> | undefined;
    void schema.then((root) => {
      complete = completeFrom(root);
      describe = describeFrom(root);
    });
    this.extensions = [
      lineNumbers(),
      history(),
      lintGutter(),
      bracketMatching(),
      closeBrackets(),
      highlightActiveLine(),
      loseLanguage,
      highlighting,
      marked,
      autocompletion({ override: [(context) => complete?.(context) ?? null], icons: false }),
      hoverTooltip((view, position) => {
        const key = describe?.(view.state.doc, position);
        return key ? { pos: key.from, end: key.to, create: () => ({ dom: element("div", { class: "key-words" }, key.words) }) } : null;
      }),
      keymap.of([...closeBracketsKeymap, ...defaultKeymap, ...historyKeymap, ...completionKeymap, ...lintKeymap, indentWithTab]),
      EditorView.contentAttributes.of({ "aria-label": "Arm file, YAML. Escape, then Tab, leaves the editor." }),
      EditorView.updateListener.of((update) => {
        if (!update.docChanged || update.transactions.some((one) => one.isUserEvent("load"))) return;
        clearTimeout(this.timer);
        this.timer = window.setTimeout(() => this.send(), REST);
      }),
      EditorView.domEventHandlers({
        mousemove: (event) => {
          const at = this.view.posAtCoords({ x: event.clientX, y: event.clientY });
          app.mark(at === null ? undefined : this.rowAt(at));
        },
        mouseleave: () => app.mark(undefined),
      }),
    ];
    this.view = new EditorView({ parent: byId("editor"), state: EditorState.create({ extensions: [...this.extensions, language.of(yaml())] }) });
    app.flush = () => {
      if (this.timer) this.send();
    };
    app.listen((change) => {
      if (change === "text") this.load();
      if (change === "messages") this.showMessages();
      if (change === "marked" || change === "arm") this.showMark();
    });
  }

  /** What is typed is checked now. */
  private send(): void {
    clearTimeout(this.timer);
    this.timer = 0;
    void this.app.check(this.view.state.doc.toString());
  }

  /** Text that came from elsewhere. */
  private load(): void {
    const { app, view } = this;
    if (view.state.doc.toString() === app.text) return;
    clearTimeout(this.timer);
    this.timer = 0;
    try {
      view.dispatch({ changes: { from: 0, to: view.state.doc.length, insert: app.text }, userEvent: "load", selection: { anchor: 0 } });
    } catch (error) {
      // The text counts, not the language or the history of the editor.
      reportError(error);
      view.setState(EditorState.create({ doc: app.text, extensions: [...this.extensions, language.of([])] }));
    }
    view.scrollDOM.scrollLeft = 0;
  }

  private showMessages(): void {
    const { app, view } = this;
    // In a transaction of its own: together with a new text the language would read the old one first.
    if (isPlain(view.state) && !isTooDeep(view.state.doc.toString())) view.dispatch({ effects: language.reconfigure(yaml()) });
    view.dispatch(setDiagnostics(view.state, app.messages.map((message) => diagnostic(message, view.state.doc))));
    const list = byId("messages");
    list.replaceChildren(
      ...app.messages.map((message) => {
        const place = message.line === undefined ? "" : `line ${message.line}: `;
        const button = element("button", { type: "button", class: `message ${message.severity}` }, `${place}${message.message}`);
        if (message.help) button.append(element("span", { class: "help" }, message.help));
        button.addEventListener("click", () => this.goTo(message));
        return button;
      }),
    );
    const mistakes = app.messages.filter((message) => message.severity === "error").length;
    const old = mistakes > 0 && app.arm ? " The picture shows the last text without mistakes." : "";
    byId("messages-title").textContent =
      app.messages.length === 0 ? "no mistakes" : `${mistakes ? `${mistakes} mistake${mistakes === 1 ? "" : "s"}.` : "Advice:"}${old}`;
    document.body.classList.toggle("has-mistakes", mistakes > 0);
  }

  private goTo(message: Message): void {
    const { view } = this;
    if (message.line === undefined) return;
    const [from] = rangeOf(message, view.state.doc);
    view.dispatch({ selection: { anchor: from }, scrollIntoView: true });
    view.focus();
  }

  /** Where the items of `joints` stand: their first and last positions. */
  private rows(): { from: number; to: number }[] {
    const { state } = this.view;
    const rows: { from: number; to: number }[] = [];
    const document = syntaxTree(state).topNode.getChild("Document");
    const map = document?.getChild("BlockMapping") ?? document?.getChild("FlowMapping");
    for (let pair = map?.firstChild ?? null; pair; pair = pair.nextSibling) {
      const key = pair.getChild("Key");
      if (!key || state.sliceDoc(key.from, key.to).trim() !== "joints") continue;
      const list = pair.getChild("BlockSequence") ?? pair.getChild("FlowSequence");
      for (let item = list?.firstChild ?? null; item; item = item.nextSibling) {
        if (item.name === "Item") rows.push({ from: item.from, to: item.to });
      }
    }
    return rows;
  }

  private rowAt(position: number): number | undefined {
    const { doc } = this.view.state;
    const line = doc.lineAt(position).number;
    const index = this.rows().findIndex(({ from, to }) => line >= doc.lineAt(from).number && line <= doc.lineAt(to).number);
    return index < 0 || index >= (this.app.facts?.rows.length ?? 0) ? undefined : index;
  }

  private showMark(): void {
    const { app, view } = this;
    const row = app.marked === undefined ? undefined : this.rows()[app.marked];
    const { doc } = view.state;
    view.dispatch({ effects: markLines.of(row && { from: doc.lineAt(row.from).number, to: doc.lineAt(row.to).number }) });
  }
}

/** Where a message points. */
function rangeOf(message: Message, doc: Text): [number, number] {
  if (message.line === undefined || message.line > doc.lines) return [0, 0];
  const line = doc.line(message.line);
  const from = Math.min(line.from + (message.column ?? 1) - 1, line.to);
  const to = Math.min(line.from + (message.end_column ?? message.column ?? 1) - 1, line.to);
  return [from, Math.max(to, Math.min(from + 1, line.to))];
}

function diagnostic(message: Message, doc: Text): Diagnostic {
  const [from, to] = rangeOf(message, doc);
  const help = message.help ? `\nhelp: ${message.help}` : "";
  return { from, to, severity: message.severity, message: message.message + help };
}
