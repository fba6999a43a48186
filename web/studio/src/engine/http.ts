// SPDX-License-Identifier: MIT
/** The engine and the files of `talus studio`, over HTTP on the loopback address. */
import type { Point } from "../geometry/plane";
import type { RunFrame, RunValue } from "../runs/liveRun";
import { type Checked, type Engine, EngineFault, type JsonSchema, type Message, openAnswer, type Solved, type SolveOptions } from "./engine";

export interface FileText {
  text: string;
  revision: string;
}

/** A text that is not saved. */
export interface JournalEntry extends FileText {
  /** Names the entry: small letters and digits. */
  window: string;
  /** The text of the file that it grew from; `revision` is that of this text. */
  base: string;
  /** When it was stored [s] since 1970. */
  time: number;
}

export interface Run {
  id: string;
  path: string;
  /** Of the text that is run. */
  revision: string;
  state: "waiting" | "running" | "done" | "failed" | "stopped";
  is_study?: boolean;
  is_stopping?: boolean;
  progress?: RunProgress | number | null;
  message?: string;
  factor?: number | null;
}

export interface RunProgress {
  /** The last line of the program. */
  line?: string;
  stage?: string;
  /** Since the start of the stage [s]. */
  time?: number;
  values?: RunValue;
  /** 0 to 1. */
  fraction?: number | null;
}

export type SaveResult = { saved: true; revision: string } | { saved: false; theirs: FileText };

export type RunEvent =
  | { kind: "progress" | "done"; data: RunProgress & { state?: Run["state"] } }
  | { kind: "value"; data: RunValue }
  | { kind: "frame"; data: RunFrame };

/** Results of a finished run. */
export interface RunResults {
  title: string;
  values: { name: string; title: string; unit: string; value: number | string | null }[];
  /** Points in [m]. */
  surfaces: { name: string; title: string; method: string; factor: number | null; points: Point[] }[];
  warnings: string[];
}

export interface RunComparison {
  inputs: { key: string; first: string | null; second: string | null; unit: string }[];
  values: {
    name: string;
    title: string;
    unit: string;
    /** "not determined" where the meshes of a runout leave it open. */
    first: number | string | null;
    second: number | string | null;
    difference: number | null;
    /** Of the first value. */
    relative: number | null;
  }[];
  warnings: string[];
}

/** The report of a run as it is now: `data` if they differ from those of the known stamp, `why` if there are none yet. */
export interface RunReport {
  active: boolean;
  stamp?: string;
  data?: unknown;
  why?: string;
}

/** Files and runs of the server; the static page has none. */
export interface Workspace {
  path: string;
  /** `open`: the file that the page opens first; may be empty. */
  listFiles(): Promise<{ files: { path: string; revision: string }[]; open?: string }>;
  readFile(path: string): Promise<FileText>;
  saveFile(path: string, file: FileText): Promise<SaveResult>;
  /** Texts of a file that are not saved, the latest first; an empty path stands for cases that were never saved. */
  readJournal(path: string): Promise<JournalEntry[]>;
  writeJournal(path: string, entry: Omit<JournalEntry, "time">): Promise<void>;
  removeJournal(path: string, window: string): Promise<void>;
  startRun(path: string, settings: Record<string, unknown>): Promise<string>;
  listRuns(): Promise<Run[]>;
  stopRun(id: string): Promise<void>;
  resumeRun(id: string): Promise<void>;
  /** Calls back with every event; returns what ends that. */
  watchRun(id: string, listen: (event: RunEvent) => void): () => void;
  reportAddress(id: string): string;
  /** The page of the reports, which shows what it is sent. */
  readonly reportPage: string;
  readReport(id: string, known: string): Promise<RunReport>;
  /** A case by `talus import`; `data` is base64. */
  importFiles(files: { name: string; data: string }[], options: Record<string, string | string[]>): Promise<{ text: string; remarks: string[] }>;
  /** A note of the page that belongs to no case file; null where there is none. */
  readNote<T>(name: string): Promise<T | null>;
  writeNote(name: string, note: unknown): Promise<void>;
  readRun(id: string): Promise<RunResults>;
  compareRuns(first: string, second: string): Promise<RunComparison>;
  /** The section (dxf) or the tables (xlsx) of a run. */
  exportRun(id: string, format: "dxf" | "xlsx"): Promise<Blob>;
  /** The section of a text as DXF. */
  exportCase(text: string): Promise<Blob>;
}

export class HttpEngine implements Engine, Workspace {
  readonly name = "talus studio";

  constructor(private readonly token: string, private readonly base = "") {}

  private async request(path: string, method: string, body?: string): Promise<{ status: number; answer: unknown }> {
    let response: Response;
    try {
      response = await fetch(this.base + path, { method, body, headers: { "X-Talus-Token": this.token } });
    } catch {
      throw new EngineFault("The program does not answer. It may have been closed; start `talus studio` again. Your text stays here.");
    }
    const text = await response.text();
    let answer: unknown = null;
    try {
      answer = text ? JSON.parse(text) : null;
    } catch {
      throw new EngineFault(`${method} ${path} gave no JSON (status ${response.status}).`);
    }
    if (response.status >= 400 && response.status !== 409) {
      openAnswer(answer);
      throw new EngineFault(`${method} ${path} failed with status ${response.status}.`);
    }
    return { status: response.status, answer };
  }

  private async get<T>(path: string, method: "GET" | "POST" | "PUT" = "GET", body?: string): Promise<T> {
    return openAnswer<T>((await this.request(path, method, body)).answer);
  }

  /** The open file, beside which the tables that a case names are found; empty for a case that was never saved. */
  path = "";

  private get query(): string {
    return this.path ? `?path=${encodeURIComponent(this.path)}` : "";
  }

  check = (text: string) => this.get<Checked>(`/api/check${this.query}`, "POST", text);
  checkMethods = async (text: string) => (await this.get<{ messages: Message[] }>(`/api/check-methods${this.query}`, "POST", text)).messages;
  solve = (text: string, options: SolveOptions) => this.get<Solved>("/api/solve", "POST", JSON.stringify({ text, options, path: this.path }));
  schema = () => this.get<JsonSchema>("/api/schema");
  template = async () => {
    const answer = await this.get<{ text: string }>("/api/template");
    return answer.text;
  };

  listFiles = () => this.get<{ files: { path: string; revision: string }[]; open?: string }>("/api/files");
  readFile = (path: string) => this.get<FileText>(`/api/files/${encodePath(path)}`);

  async saveFile(path: string, file: FileText): Promise<SaveResult> {
    const { status, answer } = await this.request(`/api/files/${encodePath(path)}`, "PUT", JSON.stringify(file));
    if (status === 409) return { saved: false, theirs: answer as FileText };
    return { saved: true, revision: openAnswer<{ revision: string }>(answer).revision };
  }

  async readJournal(path: string): Promise<JournalEntry[]> {
    return (await this.get<{ entries: JournalEntry[] }>(nameJournal(path))).entries;
  }

  async writeJournal(path: string, entry: Omit<JournalEntry, "time">): Promise<void> {
    await this.get(nameJournal(path), "PUT", JSON.stringify(entry));
  }

  async removeJournal(path: string, window: string): Promise<void> {
    await this.get(nameJournal(path), "PUT", JSON.stringify({ window, text: null }));
  }

  async startRun(path: string, settings: Record<string, unknown>): Promise<string> {
    return (await this.get<{ id: string }>("/api/runs", "POST", JSON.stringify({ path, settings }))).id;
  }

  async listRuns(): Promise<Run[]> {
    const answer = await this.get<Run[] | { runs: Run[] }>("/api/runs");
    return Array.isArray(answer) ? answer : answer.runs;
  }

  async stopRun(id: string): Promise<void> {
    await this.get(`/api/runs/${encodeURIComponent(id)}/stop`, "POST", "{}");
  }

  async resumeRun(id: string): Promise<void> {
    await this.get(`/api/runs/${encodeURIComponent(id)}/resume`, "POST", "{}");
  }

  watchRun(id: string, listen: (event: RunEvent) => void): () => void {
    const source = new EventSource(`${this.base}/api/runs/${encodeURIComponent(id)}/events?token=${encodeURIComponent(this.token)}`);
    const read = (kind: RunEvent["kind"]) => (event: MessageEvent<string>) => {
      try {
        listen({ kind, data: JSON.parse(event.data) as unknown } as RunEvent);
      } catch {
        // A line that was cut is followed by another.
      }
      if (kind === "done") source.close();
    };
    for (const kind of ["progress", "value", "frame", "done"] as const) source.addEventListener(kind, read(kind));
    return () => source.close();
  }

  importFiles = (files: { name: string; data: string }[], options: Record<string, string | string[]>) =>
    this.get<{ text: string; remarks: string[] }>("/api/import", "POST", JSON.stringify({ files, options }));
  readNote = <T>(name: string) => this.get<T | null>(`/api/aside/${encodeURIComponent(name)}`);

  async writeNote(name: string, note: unknown): Promise<void> {
    await this.get(`/api/aside/${encodeURIComponent(name)}`, "PUT", JSON.stringify(note));
  }

  readRun = (id: string) => this.get<RunResults>(`/api/runs/${encodeURIComponent(id)}/values`);
  compareRuns = (first: string, second: string) =>
    this.get<RunComparison>(`/api/compare?first=${encodeURIComponent(first)}&second=${encodeURIComponent(second)}`);

  private async getFile(path: string, asked: RequestInit = {}): Promise<Blob> {
    const response = await fetch(`${this.base}${path}`, { ...asked, headers: { "X-Talus-Token": this.token } });
    if (!response.ok) openAnswer(await response.json());
    return response.blob();
  }

  exportRun = (id: string, format: "dxf" | "xlsx") => this.getFile(`/api/runs/${encodeURIComponent(id)}/export.${format}`);
  exportCase = (text: string) => this.getFile("/api/export", { method: "POST", body: JSON.stringify({ text, path: this.path }) });

  readReport = (id: string, known: string) =>
    this.get<RunReport>(`/api/runs/${encodeURIComponent(id)}/report-data?known=${encodeURIComponent(known)}`);

  get reportPage(): string {
    return `${this.base}/report.html`;
  }

  reportAddress(id: string): string {
    return `${this.base}/api/runs/${encodeURIComponent(id)}/report?token=${encodeURIComponent(this.token)}`;
  }
}

const nameJournal = (path: string) => (path ? `/api/journal/${encodePath(path)}` : "/api/journal");
const encodePath = (path: string) => path.split("/").map(encodeURIComponent).join("/");
