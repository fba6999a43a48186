// SPDX-License-Identifier: MIT
/** The text of the case in an editor: edited here, it changes the canvas and the forms; edited there, it changes here. */
import { defaultKeymap } from "@codemirror/commands";
import { bracketMatching, HighlightStyle, StreamLanguage, syntaxHighlighting } from "@codemirror/language";
import { toml } from "@codemirror/legacy-modes/mode/toml";
import { type Diagnostic, lintGutter, setDiagnostics } from "@codemirror/lint";
import { highlightSelectionMatches, searchKeymap } from "@codemirror/search";
import { Annotation, EditorState } from "@codemirror/state";
import { drawSelection, EditorView, highlightActiveLine, keymap, lineNumbers } from "@codemirror/view";
import { tags } from "@lezer/highlight";
import { effect } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";

import { findDifference } from "../document/edits";
import * as state from "../state";
import { findOffset } from "./offsets";
import { shownSpan } from "./tabs";

/** Marks changes that come from the page and not from typing. */
const fromPage = Annotation.define<boolean>();

const look = EditorView.theme({
  "&": { height: "100%", fontSize: "13px", color: "var(--ink)", background: "var(--ground)" },
  ".cm-scroller": { fontFamily: "var(--code)", lineHeight: "1.5" },
  ".cm-content": { caretColor: "var(--ink)" },
  ".cm-gutters": { background: "var(--panel)", color: "var(--muted)", borderRight: "1px solid var(--line)" },
  ".cm-activeLine": { background: "color-mix(in srgb, var(--accent) 7%, transparent)" },
  ".cm-cursor": { borderLeftColor: "var(--ink)" },
  "&.cm-focused": { outline: "2px solid var(--accent)", outlineOffset: "-2px" },
  ".cm-selectionBackground, &.cm-focused .cm-selectionBackground": { background: "color-mix(in srgb, var(--accent) 25%, transparent)" },
  ".cm-tooltip": { background: "var(--ground)", color: "var(--ink)", border: "1px solid var(--line)" },
  ".cm-panels": { background: "var(--panel)", color: "var(--ink)" },
});

const colours = HighlightStyle.define([
  { tag: tags.comment, color: "var(--muted)", fontStyle: "italic" },
  { tag: tags.string, color: "var(--good)" },
  { tag: [tags.number, tags.bool, tags.atom], color: "var(--accent)" },
  { tag: tags.propertyName, color: "var(--ink)" },
  { tag: [tags.atom, tags.bracket], color: "var(--warn)" },
]);

function listDiagnostics(text: string): Diagnostic[] {
  const fault = state.fault.value;
  const end = text.length;
  const own: Diagnostic[] = fault ? [{ from: Math.min(fault.at, end), to: Math.min(fault.at + 1, end), severity: "error", message: fault.text }] : [];
  return [
    ...own,
    ...state.messages.value.flatMap(({ span, severity, text: message }): Diagnostic[] => {
      if (!span) return [];
      const [from, to] = [findOffset(text, span[0]), findOffset(text, span[1])];
      return [{ from: Math.min(from, end), to: Math.min(Math.max(to, from), end), severity: severity === "note" ? "info" : severity, message }];
    }),
  ];
}

/** The editor lives in a shadow root, where its styles are adopted sheets that a strict Content-Security-Policy allows. */
function makeEditor(host: HTMLElement): EditorView {
  const root = host.shadowRoot ?? host.attachShadow({ mode: "open" });
  const typed = EditorView.updateListener.of((update) => {
    if (!update.docChanged || update.transactions.some((one) => one.annotation(fromPage))) return;
    // A line of typing is one step.
    const line = update.state.doc.lineAt(update.state.selection.main.head).number;
    state.change("Edit the text", update.state.doc.toString(), `text ${line}`);
  });
  return new EditorView({
    root,
    parent: root,
    state: EditorState.create({
      doc: state.text.value,
      extensions: [
        lineNumbers(),
        drawSelection(),
        highlightActiveLine(),
        highlightSelectionMatches(),
        bracketMatching(),
        StreamLanguage.define(toml),
        syntaxHighlighting(colours),
        lintGutter(),
        keymap.of([...searchKeymap, ...defaultKeymap]),
        EditorView.contentAttributes.of({ "aria-label": "Text of the case", spellcheck: "false", tabindex: "0" }),
        look,
        typed,
      ],
    }),
  });
}

export function TextPanel() {
  const host = useRef<HTMLDivElement>(null);
  useEffect(() => {
    const editor = makeEditor(host.current!);
    const stopText = effect(() => {
      const wanted = state.text.value;
      const now = editor.state.doc.toString();
      if (now === wanted) return;
      const { from, to, insert } = findDifference(now, wanted);
      editor.dispatch({ changes: { from, to, insert }, annotations: fromPage.of(true) });
    });
    const stopMessages = effect(() => {
      const diagnostics = listDiagnostics(state.text.peek());
      const length = editor.state.doc.length;
      editor.dispatch(setDiagnostics(editor.state, diagnostics.filter(({ to }) => to <= length)));
    });
    const stopShown = effect(() => {
      const span = shownSpan.value;
      if (!span) return;
      const end = editor.state.doc.length;
      editor.dispatch({ selection: { anchor: Math.min(span[0], end), head: Math.min(span[1], end) }, scrollIntoView: true });
      editor.focus();
      shownSpan.value = null;
    });
    return () => {
      stopText();
      stopMessages();
      stopShown();
      editor.destroy();
    };
  }, []);
  return <div class="text-editor" ref={host} />;
}
