// SPDX-License-Identifier: MIT
/** Undo and redo with names, over edits of the text: of the canvas, of forms and of typing alike, without a limit. */
import { findDifference } from "../document/edits";

interface Step {
  name: string;
  /** Steps with the same key that follow one another are one: a drag, a word that is typed. */
  group: string | null;
  from: number;
  removed: string;
  inserted: string;
}

const splice = (text: string, from: number, length: number, insert: string) =>
  text.slice(0, from) + insert + text.slice(from + length);

export class History {
  private readonly done: Step[] = [];
  private undone: Step[] = [];

  constructor(public text: string) {}

  /** Records a change; returns false where the text stays as it is. */
  change(name: string, after: string, group: string | null = null): boolean {
    if (after === this.text) return false;
    const last = this.done.at(-1);
    const grouped = group !== null && last?.group === group && this.undone.length === 0;
    if (grouped) this.done.pop();
    const before = grouped ? splice(this.text, last.from, last.inserted.length, last.removed) : this.text;
    const { from, to, insert } = findDifference(before, after);
    this.undone = [];
    this.text = after;
    // A drag that returns to where it began leaves nothing to undo.
    if (before !== after) this.done.push({ name, group, from, removed: before.slice(from, to), inserted: insert });
    return true;
  }

  /** Ends a group: the next change is a step of its own. */
  seal(): void {
    const last = this.done.at(-1);
    if (last) last.group = null;
  }

  undo(): Step | null {
    const step = this.done.pop();
    if (!step) return null;
    this.text = splice(this.text, step.from, step.inserted.length, step.removed);
    this.undone.push({ ...step, group: null });
    return step;
  }

  redo(): Step | null {
    const step = this.undone.pop();
    if (!step) return null;
    this.text = splice(this.text, step.from, step.removed.length, step.inserted);
    this.done.push(step);
    return step;
  }

  get undoNames(): string[] {
    return this.done.map(({ name }) => name).toReversed();
  }

  get redoNames(): string[] {
    return this.undone.map(({ name }) => name).toReversed();
  }
}
