// SPDX-License-Identifier: MIT
/** The head and the foot of a report: its title block, the case, where it comes from, and how long it took. */

/** The title block. Empty texts are left out. */
export interface Project {
  title: string;
  project: string;
  client: string;
  author: string;
  checked_by: string;
  revision: string;
  notes: string;
  /** ISO 8601, when the run was started. */
  date: string;
}

export interface InputValue {
  value: unknown;
  given: boolean;
  unit?: string;
}

export type InputTable = { [key: string]: InputTable | InputTable[] | InputValue };

export interface Provenance {
  program: string;
  version: string;
  commit: string;
  compiler: string;
  build_type: string;
  architecture: string;
  /** Of the instruction set; packages give equal bits where it is equal. */
  level: string;
  lane_width: number;
  device: string;
  machine: string;
  threads: number;
  started: string;
  case_file: string;
  input_hash: string;
  /** Of the results folder, without its path. */
  folder: string;
}

/** Seconds. */
export interface Timing {
  wall: number;
  cpu: number;
  /** Sum over all threads. */
  parts: { name: string; title: string; seconds: number }[];
}
