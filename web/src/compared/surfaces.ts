/** The slip surfaces that can be laid over each other, with what the legends say of them. */
import { report } from "../state";

export interface NamedSurface {
  name: string;
  /** "Spencer, critical circle: F = 1.442". */
  text: string;
  method: string;
  points: number[][];
  /** Number of its colour and dashes. */
  look: number;
  /** Whether it is shown at first: of slices Spencer's alone (else the first), for the others lie close to it. */
  first: boolean;
}

export function listSurfaces(): NamedSurface[] {
  const all = (report.value.method_table?.surfaces ?? []).filter((s) => s.points.length > 1);
  const slices = all.filter((s) => s.method === "lem");
  const leading = slices.find((s) => s.name === "lem.spencer") ?? slices[0];
  const named = all.map((s) => ({
    name: s.name,
    text: s.factor === null ? s.title : `${s.title}: F = ${s.factor.toFixed(3)}`,
    method: s.method,
    points: s.points,
    first: s.method !== "lem" || s === leading || s.name === "lem.noncircular.spencer",
  }));
  // Those shown at first have the first colours.
  return [...named.filter((s) => s.first), ...named.filter((s) => !s.first)].map((s, look) => ({ ...s, look }));
}
