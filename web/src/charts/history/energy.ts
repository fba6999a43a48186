// SPDX-License-Identifier: MIT
/** The balance of energy of a history, see "Budgets" in the theory: what goes in, where it goes, what is left over. */
import type { TableColumn } from "../../contract";

const stores = ["kinetic", "elastic", "plastic", "damping"] as const;
/** Absent from results of 0.2.0 and earlier; the last two also without pore water. */
const laterStores = ["walls", "mapping", "drag", "pore_water"] as const;

export interface EnergyBalance {
  /** external work − (kinetic + elastic + plastic + damping + walls + mapping + drag + pore water), as changes since the first row [J]. */
  residual: (number | null)[];
  /** Largest change of the external work [J]. */
  work: number;
}

/** The values as changes since the first row that has one. */
export function takeChange(values: readonly (number | null)[]): (number | null)[] {
  const first = values.find((v) => v !== null) ?? 0;
  return values.map((v) => (v === null ? null : v - first));
}

/** Returns whether a column is external work; the others are the energies into which it is converted. */
export const isWork = ({ part }: Pick<TableColumn, "part">) => part === "external";

/** null when the table lacks one of the columns. */
export function findEnergyBalance(table: { columns: Pick<TableColumn, "part" | "values">[] }): EnergyBalance | null {
  const work = table.columns.find(isWork);
  const parts = stores.map((part) => table.columns.find((c) => c.part === part));
  if (!work || parts.some((p) => !p)) return null;
  parts.push(...laterStores.map((part) => table.columns.find((c) => c.part === part)));
  const changes = parts.flatMap((p) => (p ? [takeChange(p.values)] : []));
  const done = takeChange(work.values);
  const residual = done.map((w, i) => {
    if (w === null) return null;
    let sum = w;
    for (const change of changes) {
      const part = change[i];
      if (part === null || part === undefined) return null;
      sum -= part;
    }
    return sum;
  });
  return { residual, work: Math.max(0, ...done.map((w) => Math.abs(w ?? 0))) };
}
