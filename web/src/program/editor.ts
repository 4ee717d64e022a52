// The program's text: what is wrong is underlined at its column, what a code means is said where one points at it.

import { defaultKeymap, history, historyKeymap } from "@codemirror/commands";
import { HighlightStyle, StreamLanguage, syntaxHighlighting } from "@codemirror/language";
import { lintGutter, setDiagnostics, type Diagnostic as Mark } from "@codemirror/lint";
import { highlightSelectionMatches, searchKeymap } from "@codemirror/search";
import { EditorState, StateEffect, StateField, type Text } from "@codemirror/state";
import {
  Decoration,
  drawSelection,
  EditorView,
  highlightActiveLine,
  highlightActiveLineGutter,
  hoverTooltip,
  keymap,
  lineNumbers,
  type DecorationSet,
} from "@codemirror/view";
import { tags } from "@lezer/highlight";
import type { Diagnostic } from "../engine/motion_types";

export interface EditorCalls {
  changed(text: string): void;
  /** The line, from 1, that the caret has come to. */
  pointed(line: number): void;
  explain(code: string): Promise<string>;
}

const language = StreamLanguage.define({
  token(stream) {
    if (stream.eatSpace()) return null;
    if (stream.match(/^;.*/) || stream.match(/^\([^)]*\)?/)) return "comment";
    if (stream.match(/^[GM]\s*\d+(\.\d+)?/i)) return "keyword";
    if (stream.match(/^[FST]\s*[-+.\d]+/i)) return "atom";
    if (stream.match(/^[A-Z]\s*[-+]?[.\d]+/i)) return "number";
    if (stream.match(/^(o[<\d]\S*|#\S+|\[|\])/i)) return "variableName";
    stream.next();
    return null;
  },
});

const colours = HighlightStyle.define([
  { tag: tags.comment, color: "var(--quiet)", fontStyle: "italic" },
  { tag: tags.keyword, color: "var(--accent)", fontWeight: "600" },
  { tag: tags.atom, color: "var(--y)" },
  { tag: tags.variableName, color: "var(--good)" },
]);

const theme = EditorView.theme({
  "&": { height: "100%", backgroundColor: "var(--paper)", color: "var(--ink)", fontSize: "13px" },
  "&.cm-focused, &:focus-within": { outline: "2px solid var(--accent)", outlineOffset: "-2px" },
  ".cm-content": { fontFamily: "ui-monospace, monospace", caretColor: "var(--ink)" },
  ".cm-cursor": { borderLeftColor: "var(--ink)" },
  ".cm-gutters": { backgroundColor: "var(--paper)", color: "var(--quiet)", borderRight: "1px solid var(--rule)" },
  ".cm-activeLine, .cm-activeLineGutter": { backgroundColor: "var(--grid)" },
  ".cm-selectionBackground, &.cm-focused .cm-selectionBackground": { backgroundColor: "var(--accent-soft) !important" },
  ".cm-moving": { backgroundColor: "var(--accent-soft)", boxShadow: "inset 3px 0 var(--accent)" },
  ".cm-tooltip, .cm-panels": {
    backgroundColor: "var(--paper)",
    color: "var(--ink)",
    border: "1px solid var(--field)",
    borderRadius: "6px",
  },
  ".cm-tooltip pre": { margin: "0", padding: "8px 10px", maxWidth: "520px", whiteSpace: "pre-wrap" },
  ".cm-textfield, .cm-button": {
    backgroundImage: "none",
    backgroundColor: "var(--paper)",
    color: "var(--ink)",
    border: "1px solid var(--field)",
  },
});

const setMoving = StateEffect.define<number>();
/** The line in motion. */
const moving = StateField.define<DecorationSet>({
  create: () => Decoration.none,
  update(marks, transaction) {
    let now = marks.map(transaction.changes);
    for (const effect of transaction.effects) {
      if (!effect.is(setMoving)) continue;
      const line = effect.value;
      const isThere = line >= 1 && line <= transaction.state.doc.lines;
      now = isThere
        ? Decoration.set(Decoration.line({ class: "cm-moving" }).range(transaction.state.doc.line(line).from))
        : Decoration.none;
    }
    return now;
  },
  provide: (field) => EditorView.decorations.from(field),
});

/** From a column in bytes of UTF-8. */
function placeOf(doc: Text, line: number, column: number): { from: number; to: number } {
  if (line < 1 || line > doc.lines) return { from: 0, to: Math.min(1, doc.length) };
  const { from, to, text } = doc.line(line);
  if (column < 1) return { from, to };
  let bytes = 0;
  let at = 0;
  for (const character of text) {
    if (bytes >= column - 1) break;
    bytes += new TextEncoder().encode(character).length;
    at += character.length;
  }
  const word = /^([A-Z]\s*[-+]?[.\d]+|\S)/i.exec(text.slice(at))?.[0] ?? "";
  const begin = Math.min(from + at, to);
  return { from: begin, to: Math.min(begin + Math.max(1, word.length), Math.max(to, begin)) };
}

function markOf(doc: Text, diagnostic: Diagnostic): Mark {
  return {
    ...placeOf(doc, diagnostic.line, diagnostic.column),
    severity: (["info", "warning", "error"] as const)[diagnostic.severity] ?? "error",
    source: diagnostic.code,
    message: diagnostic.hint === "" ? diagnostic.message : `${diagnostic.message}\n${diagnostic.hint}`,
  };
}

export class Editor {
  readonly element = document.createElement("div");
  private readonly view: EditorView;
  private moved = 0;
  private isSetting = false;

  constructor(
    text: string,
    private readonly calls: EditorCalls,
  ) {
    this.element.className = "editor";
    this.view = new EditorView({ parent: this.element, state: this.stateOf(text) });
  }

  get text(): string {
    return this.view.state.doc.toString();
  }

  set(text: string): void {
    this.view.setState(this.stateOf(text));
    this.moved = 0;
  }

  mark(diagnostics: readonly Diagnostic[]): void {
    const { doc } = this.view.state;
    this.view.dispatch(
      setDiagnostics(
        this.view.state,
        diagnostics.map((each) => markOf(doc, each)),
      ),
    );
  }

  /** The line in motion; in sight where the reader does not look elsewhere. */
  move(line: number, isSeen: boolean): void {
    if (line === this.moved) return;
    this.moved = line;
    const isThere = line >= 1 && line <= this.view.state.doc.lines;
    const scroll = isThere && isSeen ? [EditorView.scrollIntoView(this.view.state.doc.line(line).from)] : [];
    this.view.dispatch({ effects: [setMoving.of(line), ...scroll] });
  }

  /** The caret there, without telling that it was moved. */
  goTo(line: number, column = 0): void {
    if (line < 1 || line > this.view.state.doc.lines) return;
    const { from } = placeOf(this.view.state.doc, line, column);
    this.isSetting = true;
    this.view.dispatch({ selection: { anchor: from }, effects: EditorView.scrollIntoView(from, { y: "center" }) });
    this.isSetting = false;
  }

  get hasFocus(): boolean {
    return this.view.hasFocus;
  }

  private stateOf(text: string): EditorState {
    return EditorState.create({
      doc: text,
      extensions: [
        lineNumbers(),
        lintGutter(),
        history(),
        drawSelection(),
        highlightActiveLine(),
        highlightActiveLineGutter(),
        highlightSelectionMatches(),
        language,
        syntaxHighlighting(colours),
        moving,
        theme,
        this.explaining(),
        EditorView.contentAttributes.of({ "aria-label": "Part program", tabindex: "0", spellcheck: "false" }),
        keymap.of([...defaultKeymap, ...historyKeymap, ...searchKeymap]),
        EditorView.updateListener.of((update) => {
          if (update.docChanged) this.calls.changed(update.state.doc.toString());
          else if (update.selectionSet && !this.isSetting)
            this.calls.pointed(update.state.doc.lineAt(update.state.selection.main.head).number);
        }),
      ],
    });
  }

  private explaining() {
    return hoverTooltip(async (view, at) => {
      const { from, text } = view.state.doc.lineAt(at);
      for (const found of text.matchAll(/[GM]\s*\d+(\.\d+)?/gi)) {
        const begin = from + found.index;
        if (at < begin || at > begin + found[0].length) continue;
        const said = await this.calls.explain(found[0]);
        if (said === "") return null;
        return {
          pos: begin,
          end: begin + found[0].length,
          above: true,
          create: () => {
            const dom = document.createElement("pre");
            dom.className = "explanation";
            dom.textContent = said.trimEnd();
            return { dom };
          },
        };
      }
      return null;
    });
  }
}
