// SPDX-License-Identifier: MIT
/** A real report (TALUS_REPORT) against the results folder that it was made from (TALUS_RESULTS). */
import { existsSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { describe, expect, it } from "vitest";

import type { Sequence } from "../src/contract";
import { readValues } from "../src/data";
import { findGiven, readColumns, readJson, readReportFile } from "./reportFile";

const given = findGiven();
const folder = given?.results ?? "";

describe.skipIf(!given?.results)("a report says what the results say", () => {
  const { report, source } = given ? readReportFile(given.page) : ({} as never);
  const summary = folder ? readJson(folder, "summary.json") : null;
  const runouts: any[] = summary?.runouts ?? [];
  const runoutOf = (s: Sequence) => runouts.find((r) => Math.abs(r.srf - s.frames[0]!.factor!) < 1e-9);
  const runoutSequences = report?.sequences?.filter((s) => s.kind === "runout") ?? [];

  it("the summary as it is, its title and its warnings", () => {
    expect(report.result).toEqual(summary);
    expect(report.title).toBe(summary.title);
    for (const warning of summary.warnings) expect(report.warnings).toContain(warning);
  });

  it("the same factor of safety, by every criterion", () => {
    const found = summary.factor_of_safety;
    const own = report.answer.factors.filter((factor) => factor.method === "mpm");
    if (!found) return expect(own).toEqual([]);
    const main = own.filter((factor) => factor.main);
    expect(main.map((factor) => factor.value)).toEqual([found.value]);
    const text = report.answer.sentences.join(" ");
    if (found.value !== null) expect(text).toContain(found.value.toFixed(3));
    if (found.frozen) expect(findFactor("frozen")?.value).toBe(found.frozen.factor);
    for (const criterion of found.criteria ?? []) {
      const shown = findFactor(criterion.name);
      expect([shown?.value, shown?.lower, shown?.upper], criterion.name).toEqual([
        criterion.factor, criterion.lower, criterion.upper,
      ]);
    }
  });
  const findFactor = (name: string) => report.answer.factors.find((f) => f.name === `factor_of_safety.${name}`);

  it("the same numbers of every runout", () => {
    for (const { srf, runout } of runouts)
      for (const key of ["moved_volume", "front_advance", "crest_retreat", "largest_displacement"]) {
        const name = `runout[${srf}].${key}`;
        expect(report.answer.results.find((result) => result.name === name)?.value, name).toBe(runout[key]);
      }
  });

  it("the same mesh", () => {
    const { nodes, elements, points, smallest_altitude, critical_time_step } = report.model.mesh;
    const { mesh } = summary;
    if (!mesh) return expect([nodes, elements, points]).toEqual([0, 0, 0]);
    expect([nodes, elements, points]).toEqual([mesh.nodes, mesh.elements, mesh.points]);
    expect([smallest_altitude, critical_time_step]).toEqual([mesh.smallest_altitude, mesh.critical_time_step]);
  });

  it("the same histories", () => {
    for (const name of ["history", "monitors"]) {
      const path = join(folder, `${name}.csv`);
      if (!existsSync(path)) continue;
      const columns = readColumns(path);
      const table = report.tables.find((t) => t.id === name);
      expect(table, `table '${name}'`).toBeDefined();
      const time = columns.get("time")!;
      // A long history may be thinned; its first and last rows stay.
      expect([table!.x.values[0], table!.x.values.at(-1)]).toEqual([time[0], time.at(-1)]);
      const rows = table!.x.values.map((t) => time.indexOf(t!));
      expect(rows.every((row) => row >= 0)).toBe(true);
      const column = table!.columns.find((c) => c.name.endsWith("displacement_x") || c.name === "kinetic_energy")!;
      const si = column.unit === "mm" ? 1e-3 : 1;
      column.values.forEach((v, i) => expect(v! * si).toBeCloseTo(columns.get(column.name)![rows[i]!]!, 9));
    }
  });

  it("frames of a runout whose largest displacement is that of its history at that time", async () => {
    for (const s of runoutSequences) {
      const columns = readColumns(join(findTrial(runoutOf(s).srf), "history.csv"));
      const [time, largest] = [columns.get("time")!, columns.get("largest_displacement")!];
      const field = s.fields.find((f) => f.name === "displacement")!;
      const values = await readValues(field.values, source);
      const step = (field.values.range![1] - field.values.range![0]) / 65534;
      let compared = 0;
      s.frames.forEach((frame, f) => {
        // The history is thinned to a few hundred rows: only frames that fall on a row are compared.
        const row = time.findIndex((t) => Math.abs(t - frame.time) < 1e-9);
        if (row < 0) return;
        const shown = largestOf(values.subarray(f * s.point_count, (f + 1) * s.point_count));
        // Fewer points than the run has may miss the largest, never exceed it.
        const missed = s.point_count < summary.mesh.points ? 0.05 * largest[row]! : 0;
        expect(shown, `${s.id}, t = ${frame.time}`).toBeLessThanOrEqual(largest[row]! + step);
        expect(shown, `${s.id}, t = ${frame.time}`).toBeGreaterThanOrEqual(largest[row]! - step - missed);
        ++compared;
      });
      expect(compared, `${s.id}: frames on a row of the history`).toBeGreaterThanOrEqual(2);
    }
  });

  it("points of the last frame of a runout that make up the moved volume", async () => {
    for (const s of runoutSequences) {
      if (s.point_count < summary.mesh.points) continue;
      const { moved_volume, moved_threshold } = runoutOf(s).runout;
      const take = async (name: string) => {
        const { values } = s.fields.find((f) => f.name === name)!;
        const step = (values.range![1] - values.range![0]) / 65534;
        return { last: (await readValues(values, source)).slice(-s.point_count), step };
      };
      const [u, volume] = [await take("displacement"), await take("volume")];
      const sum = (threshold: number) => volume.last.reduce((a, v, i) => (u.last[i]! > threshold ? a + v : a), 0);
      // Points as near to the threshold as the rounding may count or not.
      const slack = s.point_count * volume.step;
      expect(sum(moved_threshold + u.step)).toBeLessThanOrEqual(moved_volume + slack);
      expect(sum(moved_threshold - u.step)).toBeGreaterThanOrEqual(moved_volume - slack);
    }
  });

  it("a sequence for the stages, the curve and every runout", () => {
    if (report.result.status !== "finished" || report.kind !== "run") return;
    const ids = report.sequences.map((s) => s.id);
    if (summary.methods && !summary.methods.asked.includes("mpm")) return expect(ids).toEqual([]);
    expect(ids).toContain("stages");
    if ((summary.curve?.points?.length ?? 0) > 0) expect(ids).toContain("curve");
    expect(runoutSequences.map((s) => runoutOf(s)?.srf)).toEqual(runouts.map((r) => r.srf));
    for (const s of report.sequences.filter((one) => one.kind === "curve"))
      for (const frame of s.frames) expect(summary.curve.points.map((p: any) => p.srf)).toContain(frame.factor);
  });

  const largestOf = (values: Float32Array) => values.reduce((a, v) => (v > a ? v : a), 0);
  const findTrial = (srf: number) => {
    const trials = readdirSync(join(folder, "trials"));
    return join(folder, "trials", trials.find((name) => Number(name.slice("srf_".length)) === srf)!);
  };
});
