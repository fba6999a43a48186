// SPDX-License-Identifier: MIT
/** A real report (TALUS_REPORT=report.html) against the contract: schema, arrays, and what the numbers must obey. */
import Ajv from "ajv";
import { readFileSync } from "node:fs";
import { describe, expect, it } from "vitest";

import type { PackedPlaces, Sequence } from "../src/contract";
import { readIntegers, readPlaces, readValues } from "../src/data";
import { measureSpacing } from "../src/viewer/extent";
import { findWaterTable } from "../src/viewer/tracedLines";
import { findGiven, findPackedArrays, readReportFile } from "./reportFile";

const given = findGiven();

describe.skipIf(!given)("a report holds the contract", () => {
  const { report, document, arrays, doubled, source } = given ? readReportFile(given.page) : ({} as never);
  const packed = given ? findPackedArrays(report) : [];

  it("has the shape of contract/report.schema.json", () => {
    const schema = JSON.parse(readFileSync(new URL("../contract/report.schema.json", import.meta.url), "utf8"));
    const validate = new Ajv({ allErrors: true }).compile(schema);
    validate(document);
    expect(validate.errors ?? []).toEqual([]);
  });

  it("names every array once, and holds no array that nothing names", () => {
    expect(doubled).toEqual([]);
    expect([...arrays.keys()].sort()).toEqual(packed.map((array) => array.id).sort());
  });

  it("holds arrays that decode to their shapes; only a range has room for 'no value'", async () => {
    for (const array of packed) {
      const values = "origin" in array ? await readPlaces(array as PackedPlaces, source) : await readValues(array, source);
      expect(values.length, array.id).toBe(array.shape.reduce((a, b) => a * b, 1));
      if ("origin" in array && array.type === "u16") continue;
      if (array.range) expect(array.range[1], array.id).toBeGreaterThanOrEqual(array.range[0]);
      else expect(values.every(Number.isFinite), array.id).toBe(true);
      expect(array.type === "u16" || !array.range, `${array.id} has a range`).toBe(true);
    }
  });

  it("has sequences whose arrays agree with their frames and points", async () => {
    for (const s of report.sequences) {
      const [frames, points] = [s.frames.length, s.point_count];
      expect(frames, s.id).toBeGreaterThan(0);
      expect([s.ids.shape, s.materials.shape], s.id).toEqual([[points], [points]]);
      expect(s.positions.shape, s.id).toEqual([frames, points, report.model.dimension]);
      for (const field of s.fields) {
        expect(field.values.shape, field.name).toEqual([frames, points]);
        expect(field.scale[1], `${s.id}: scale of ${field.name}`).toBeGreaterThanOrEqual(field.scale[0]);
      }
      const axis = s.frames.map((frame) => (s.axis === "time" ? frame.time : frame.factor ?? Number.NaN));
      expect(axis, `${s.id}: frames are in order`).toEqual([...axis].sort((a, b) => a - b));
      expect(new Set(await readIntegers(s.ids, source)).size, `${s.id}: ids are unique`).toBe(points);
      const known = new Set(report.model.materials.map((material) => material.index));
      for (const material of new Set(await readIntegers(s.materials, source))) expect(known).toContain(material);
    }
    const names = report.sequences.map((s) => s.id);
    expect(new Set(names).size).toBe(names.length);
  });

  it("a point has a value in all fields of a frame, or in none; dry soil has no water", async () => {
    const wet = new Set(report.model.materials.filter((m) => m.water).map((m) => m.index));
    // A soil may have no such quantity, and preconsolidation is set at the end of a stage.
    const ofSoil = /^(preconsolidation_pressure|void_ratio)$/;
    const ofWater = /^(pore_pressure|saturation|darcy_velocity(_[xyz])?)$/;
    for (const s of report.sequences) {
      const dimension = report.model.dimension;
      const positions = await readPlaces(s.positions, source);
      const materials = await readIntegers(s.materials, source);
      const isDry = (i: number) => !wet.has(materials[i % s.point_count]!);
      for (const field of s.fields) {
        if (ofSoil.test(field.name)) continue;
        const values = await readValues(field.values, source);
        const isGone = (i: number) =>
          Number.isNaN(positions[i * dimension]!) || (ofWater.test(field.name) && isDry(i));
        const differing = values.findIndex((v, i) => Number.isNaN(v) !== isGone(i));
        expect(differing, `${s.id}: ${field.name}`).toBe(-1);
      }
    }
  });

  it("has water that is somewhere: budgets close, what flows in steadily flows out, laws fall with suction", () => {
    const { water: budget, seepage } = report.result;
    const { water } = report;
    expect(water !== undefined).toBe(report.model.materials.some((m) => m.water));
    for (const { name, water: soil } of report.model.materials) {
      if (!soil) continue;
      const falls = (values: number[]) => values.every((v, i) => i === 0 || v <= values[i - 1]! * (1 + 1e-12));
      const { suction, saturation, conductivity } = soil.curves;
      expect([suction.length, falls([...suction].reverse())], name).toEqual([saturation.length, true]);
      expect([falls(saturation), falls(conductivity)], name).toEqual([true, true]);
      expect(saturation.every((s) => s >= 0 && s <= 1), name).toBe(true);
    }
    if (budget) {
      const { surfaces, initial, stored, left_grid, lost_between, pressed_in, error } = budget;
      const passed = surfaces.reduce((sum, s) => sum + s.entered - s.left, 0);
      const open = stored - (initial + passed + pressed_in - left_grid - lost_between);
      expect(Math.abs(open) / stored).toBeLessThan(Math.abs(error) + 1e-9);
      for (const s of surfaces) expect(s.runoff, s.name).toBeLessThanOrEqual(s.supplied * (1 + 1e-9) + 1e-12);
    }
    if (seepage) {
      const { discharges, inflow, outflow, balance_error } = seepage;
      const sum = (key: "inflow" | "outflow") => discharges.reduce((total, d) => total + d[key], 0);
      expect(Math.abs(sum("inflow") - sum("outflow"))).toBeLessThan(Math.abs(balance_error) + 1e-6 * inflow);
      expect(Math.abs(sum("outflow") - outflow)).toBeLessThan(1e-6 * outflow);
    }
  });

  it("draws the water table of the first frame where the steady seepage has it", async () => {
    const start = report.result.water_states?.at(-1);
    const stages = report.sequences.find((s) => s.kind === "stages");
    const field = stages?.fields.find((f) => f.name === "pore_pressure");
    if (!start || !report.result.seepage || !stages || !field) return;
    const count = stages.point_count;
    const positions = (await readPlaces(stages.positions, source)).slice(0, 2 * count);
    const pressure = (await readValues(field.values, source)).slice(0, count);
    const spacing = measureSpacing(positions, 2, report.model.mesh.mean_size);
    const lines = findWaterTable(positions, pressure, () => true, spacing);
    expect(lines.length).toBeGreaterThan(0);
    // The first frame is the initial state; an element has one pressure, so the position of zero inside it is unknown.
    const distances = lines.flat().map(([x, y]) => {
      const pieces = start.water_table.flatMap((line) => line.slice(1).map((p, k) => [line[k]!, p] as const));
      const piece = pieces.find(([a, b]) => Math.min(a[0]!, b[0]!) <= x && x <= Math.max(a[0]!, b[0]!));
      if (!piece) return 0;
      const [a, b] = piece;
      return Math.abs(y - (a[1]! + ((x - a[0]!) / (b[0]! - a[0]! || 1)) * (b[1]! - a[1]!)));
    });
    distances.sort((a, b) => a - b);
    expect(distances[Math.floor(0.9 * distances.length)]).toBeLessThan(report.model.mesh.mean_size);
  });

  it("has points inside the box", async () => {
    const [low, high] = report.model.bounds;
    for (const s of report.sequences) {
      const dimension = report.model.dimension;
      (await readPlaces(s.positions, source)).forEach((x, i) => {
        const axis = i % dimension;
        const slack = s.positions.step[axis]!;
        if (x < low[axis]! - slack || x > high[axis]! + slack) throw new Error(`${s.id}: ${x} on axis ${axis}`);
      });
    }
  });

  it("moves points by their displacement, and gives its length", async () => {
    for (const s of report.sequences) await checkMotion(s);
  });

  it("has a mean stress that is the mean, a deviatoric stress that follows from the components", async () => {
    // A study shows no stresses of its variants.
    for (const s of report.sequences) if (report.kind === "run") await checkStress(s);
  });

  it("has a mesh whose cells name its nodes and fill the box or less", async () => {
    const { positions, cells } = report.model.mesh;
    if (!positions || !cells) return;
    const dimension = report.model.dimension;
    expect(positions.shape[1]).toBe(dimension);
    expect(cells.shape[1]).toBe(dimension + 1);
    const x = await readPlaces(positions, source);
    const nodes = await readIntegers(cells, source);
    let last = 0;
    for (const node of nodes) last = Math.max(last, node);
    expect(last).toBeLessThan(positions.shape[0]!);
    if (dimension !== 2) return;
    let area = 0;
    for (let i = 0; i < nodes.length; i += 3) {
      const [a, b, c] = [nodes[i]! * 2, nodes[i + 1]! * 2, nodes[i + 2]! * 2];
      area += Math.abs((x[b]! - x[a]!) * (x[c + 1]! - x[a + 1]!) - (x[c]! - x[a]!) * (x[b + 1]! - x[a + 1]!)) / 2;
    }
    const [low, high] = report.model.bounds;
    expect(area).toBeLessThanOrEqual((high[0]! - low[0]!) * (high[1]! - low[1]!) * (1 + 1e-5));
    expect(area).toBeGreaterThan(0);
  });

  const findStep = (range: [number, number]) => (range[1] - range[0]) / 65534;
  const findField = (s: Sequence, name: string) => s.fields.find((field) => field.name === name);

  /** x(t) - x(0) = u(t) - u(0); both sides are rounded to a step of their range. */
  async function checkMotion(s: Sequence) {
    const dimension = report.model.dimension;
    const x = await readPlaces(s.positions, source);
    const parts = ["x", "y", "z"].slice(0, dimension).map((axis) => findField(s, `displacement_${axis}`));
    const length = findField(s, "displacement");
    if (!length || parts.some((part) => !part)) throw new Error(`${s.id} has no displacement and its components`);
    const u = await Promise.all(parts.map((part) => readValues(part!.values, source)));
    const size = await readValues(length.values, source);
    const steps = parts.map((part) => findStep(part!.values.range!));
    const slack = steps.reduce((a, b) => a + b, 0) / 2 + findStep(length.values.range!) / 2 + 1e-6;
    // Displacements start anew with a stage that resets them: within a runout, and along the curve, they do not.
    const moves = s.kind !== "stages";
    for (let i = 0; i < size.length; ++i) {
      if (Number.isNaN(size[i]!)) continue;
      const expected = Math.hypot(...u.map((part) => part[i]!));
      if (!(Math.abs(size[i]! - expected) <= slack))
        throw new Error(`${s.id}: |u| of ${i} is ${size[i]}, not ${expected}`);
      for (let axis = 0; moves && axis < dimension; ++axis) {
        const first = i % s.point_count;
        const moved = x[i * dimension + axis]! - x[first * dimension + axis]!;
        const difference = moved - (u[axis]![i]! - u[axis]![first]!);
        const room = s.positions.step[axis]! + steps[axis]! + 1e-5;
        if (Math.abs(difference) > room) throw new Error(`${s.id}: point ${first} moves ${difference} m more than u`);
      }
    }
  }

  /** p = (σxx + σyy + σzz)/3, q = √(3 J2), within the rounding of what they follow from. */
  async function checkStress(s: Sequence) {
    const names = report.model.dimension === 2 ? ["xx", "yy", "zz", "xy"] : ["xx", "yy", "zz", "xy", "yz", "xz"];
    const all = [...names.map((name) => `stress_${name}`), "mean_stress", "deviatoric_stress"];
    const fields = all.map((name) => findField(s, name));
    if (fields.some((field) => !field)) throw new Error(`${s.id} has no stress, or not all of its components`);
    const values = await Promise.all(fields.map((field) => readValues(field!.values, source)));
    const rounding = fields.reduce((sum, field) => sum + findStep(field!.values.range!), 0);
    for (let i = 0; i < values[0]!.length; ++i) {
      const [xx, yy, zz, ...shear] = values.slice(0, -2).map((v) => v[i]!) as [number, number, number, ...number[]];
      if (Number.isNaN(xx)) continue;
      const p = (xx + yy + zz) / 3;
      const j2 = ((xx - p) ** 2 + (yy - p) ** 2 + (zz - p) ** 2) / 2 + shear.reduce((sum, t) => sum + t * t, 0);
      const [mean, q] = values.slice(-2).map((v) => v[i]!) as [number, number];
      if (Math.abs(mean - p) > rounding) throw new Error(`${s.id}: mean stress of ${i} is ${mean}, not ${p}`);
      const expected = Math.sqrt(3 * j2);
      if (Math.abs(q - expected) > 2 * rounding) throw new Error(`${s.id}: q of ${i} is ${q}, not ${expected}`);
    }
  }
});
