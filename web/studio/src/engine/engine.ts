// SPDX-License-Identifier: MIT
/** The engine as the page uses it: functions from the text of a case to answers, over HTTP or in a WebAssembly worker. */
import type { Point } from "../geometry/plane";

export interface Message {
  severity: "error" | "warning" | "note";
  /** Path of the key that it is about: "materials.clay.cohesion"; empty for none. */
  key: string;
  text: string;
  /** Bytes of the UTF-8 text; null where it has no place. */
  span: [number, number] | null;
  /** A point of the section; null where it has none. */
  place?: Point | null;
}

/** What a canvas needs beyond the text, in metres; parts that a case does not have are missing. */
export interface Section {
  regions: { name: string; soil: string; polygon: Point[] }[];
  ground?: Point[];
  water_tables?: { name: string; points: Point[]; is_later?: boolean }[];
  ponds?: Point[][];
  loads?: { text: string; line: Point[]; load: Point[] }[];
  supports?: { name: string; head: Point; end: Point; free?: Point | number | null }[];
  conditions?: { kind: string; text: string; line: Point[]; outward?: Point }[];
  /** Conditions of water on sides. */
  water_sides?: { kind: string; text: string; line: Point[] }[];
  notes?: string[];
}

export interface Checked {
  messages: Message[];
  section: Section | null;
  ready?: boolean;
}

export interface SolveOptions {
  methods?: string[];
  /** At most about this many circles in one quick search. */
  circles?: number;
}

export interface Circle {
  centre: Point;
  radius: number;
}

export interface SolvedSurface {
  method: string;
  title?: string;
  factor: number | null;
  points: Point[];
  circle: Circle | null;
  circular?: boolean;
}

export interface Solved {
  /** null: no surface has a factor. */
  factor: number | null;
  method: string;
  title?: string;
  surface: Point[];
  circle: Circle | null;
  searched: number;
  surfaces?: SolvedSurface[];
  messages?: Message[];
}

export interface Engine {
  name: string;
  check(text: string): Promise<Checked>;
  /** Checks that need meshes, in a second or more; missing where the engine has none. */
  checkMethods?(text: string): Promise<Message[]>;
  solve(text: string, options: SolveOptions): Promise<Solved>;
  schema(): Promise<JsonSchema>;
  template(): Promise<string>;
}

/** The parts of JSON Schema that `talus schema` uses. */
export interface JsonSchema {
  type?: string;
  description?: string;
  default?: unknown;
  enum?: (string | number | boolean)[];
  const?: unknown;
  minimum?: number;
  maximum?: number;
  exclusiveMinimum?: number;
  exclusiveMaximum?: number;
  pattern?: string;
  items?: JsonSchema;
  properties?: Record<string, JsonSchema>;
  additionalProperties?: JsonSchema | boolean;
  required?: string[];
  anyOf?: JsonSchema[];
  allOf?: JsonSchema[];
  if?: JsonSchema;
  then?: JsonSchema;
}

/** An answer that is an error becomes one. */
export class EngineFault extends Error {}

export function openAnswer<T>(answer: unknown): T {
  if (typeof answer === "object" && answer !== null && "error" in answer) {
    const { error } = answer as { error: unknown };
    if (typeof error === "string") throw new EngineFault(error);
  }
  return answer as T;
}
