/** Slices, finite elements and material points beside each other, and partial factors. */

/** Factors of safety by method, and the surfaces that the methods found. */
export interface MethodTable {
  /** "lem", "fem", "mpm", as the case asks for them. */
  asked: string[];
  rows: MethodRow[];
  surfaces: MethodSurface[];
  /** Surfaces of one method that slices were cut on. */
  handed: { from: string; to: string; title: string; factor: number | null; refusal: string }[];
  /** Where the methods differ, and why; "Slices", "Mechanism". */
  reading: { topic: string; sentences: string[] }[];
  partial_factors?: PartialFactors;
}

export interface MethodRow {
  /** "lem", "fem", "mpm". */
  method: string;
  /** "spencer". */
  name: string;
  title: string;
  /** "critical circle", "no equilibrium". */
  criterion: string;
  /** Of `surfaces`; empty where there is none. */
  surface: string;
  /** Where that surface comes from: slices find "critical" circles and "noncircular" polylines themselves. */
  source: "none" | "critical" | "noncircular" | "given" | "handed" | "optimised" | "band" | "slip_line";
  /** null: none was found, `note` says why. */
  factor: number | null;
  lower: number | null;
  upper: number | null;
  /** Computing time; null where it is not known by itself. */
  seconds: number | null;
  note: string;
}

export interface MethodSurface {
  /** "lem.spencer", "fem.band", "mpm.slip_line". */
  name: string;
  title: string;
  method: string;
  factor: number | null;
  /** [m] */
  points: number[][];
}

/** Design values after Eurocode 7, or by hand. */
export interface PartialFactors {
  /** "DA1-2". */
  set: string;
  values: { key: string; title: string; symbol: string; value: number }[];
  /** Characteristic and design values, in `unit`. */
  materials: {
    material: string;
    quantity: string;
    symbol: string;
    unit: string;
    characteristic: number;
    design: number;
  }[];
  /** Sentences. */
  notes: string[];
  /** Factor of safety with the design values; null where it is not known. */
  over_design: number | null;
  text: string;
}
