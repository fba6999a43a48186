// SPDX-License-Identifier: MIT
/** Bars of FEM and MPM in one form: axial force along each, and how far its limits are used. */
import type { Report } from "../contract";

export interface BarRow {
  name: string;
  /** Distances from the head [m]. */
  place: (number | null)[];
  /** Axial force there [N/m]. */
  force: (number | null)[];
  /** Bending moment and shear force there, of piles and walls [N m/m], [N/m]. */
  moments: (number | null)[];
  shears: (number | null)[];
  /** The same at full strength of the soil. */
  startMoments: (number | null)[];
  startShears: (number | null)[];
  /** Of walls at full strength: distances from the head, displacement towards the left of the way to the toe [m]. */
  deflection: { place: (number | null)[]; value: (number | null)[] };
  /** Wall on which the head presses. */
  onWall: string | null;
  largest: number | null;
  plate: number | null;
  moment: number | null;
  tension: number | null;
  pullOut: number | null;
  stripping: number | null;
  bending: number | null;
  shear: number | null;
  limit: string;
}

export interface BarTable {
  id: string;
  title: string;
  /** When the forces act. */
  state: string;
  rows: BarRow[];
}

const limits: Record<string, string> = {
  none: "–",
  tension: "tensile strength",
  pull_out: "pull-out",
  stripping: "stripping",
  bending: "plastic moment",
  shear: "shear strength",
  torn: "torn",
};

interface Bar {
  support: string;
  row: number | null;
  place: (number | null)[];
  force: (number | null)[];
  largest: number | null;
  plate: number | null;
  moments?: (number | null)[];
  shears?: (number | null)[];
  moments_at_start?: (number | null)[];
  shears_at_start?: (number | null)[];
  deflection?: { place: (number | null)[]; value: (number | null)[] };
  on_wall?: string;
  moment?: number | null;
  tension?: number | null;
  pull_out?: number | null;
  stripping?: number | null;
  bending?: number | null;
  shear?: number | null;
  limit: string;
}

const makeRow = (bar: Bar): BarRow => ({
  name: `${bar.support} ${bar.row}`,
  place: bar.place,
  force: bar.force,
  moments: bar.moments ?? [],
  shears: bar.shears ?? [],
  startMoments: bar.moments_at_start ?? [],
  startShears: bar.shears_at_start ?? [],
  deflection: bar.deflection ?? { place: [], value: [] },
  onWall: bar.on_wall ?? null,
  largest: bar.largest,
  plate: bar.plate,
  moment: bar.moment ?? null,
  tension: bar.tension ?? null,
  pullOut: bar.pull_out ?? null,
  stripping: bar.stripping ?? null,
  bending: bar.bending ?? null,
  shear: bar.shear ?? null,
  limit: limits[bar.limit] ?? bar.limit,
});

/** One table for each strength reduction by FEM with supports, and one for MPM. */
export function listBarTables({ result }: Report): BarTable[] {
  const tables: BarTable[] = [];
  for (const run of result.fem?.runs ?? [])
    if (run.supports && run.supports.length > 0)
      tables.push({
        id: `fem-${run.flow}`,
        title: `FEM, ${run.flow === "associated" ? "ψ = φ" : "ψ as given"}`,
        state: "at failure",
        rows: run.supports.map(makeRow),
      });
  if (result.supports && result.supports.length > 0)
    tables.push({ id: "mpm", title: "MPM", state: "at the end of the stages", rows: result.supports.map(makeRow) });
  return tables;
}
