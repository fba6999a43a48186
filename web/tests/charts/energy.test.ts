// SPDX-License-Identifier: MIT
// The residual of the energy balance: zero for exact mechanics, and exactly the energy that was put aside.
import { expect, test } from "vitest";

import { findEnergyBalance } from "../../src/charts/history/histories";
import type { TableColumn } from "../../src/contract";

const column = (part: TableColumn["part"], values: (number | null)[]) => ({ part, values });
const times = Array.from({ length: 50 }, (_, i) => i * 0.02);

/** A weight m on a spring k, released from rest: x = (mg/k)(1 - cos ωt), whose energies are known in closed form. */
function makeOscillator(lost: number) {
  const [m, k, g] = [2, 300, 9.81];
  const omega = Math.sqrt(k / m);
  const x = times.map((t) => ((m * g) / k) * (1 - Math.cos(omega * t)));
  const v = times.map((t) => ((m * g) / k) * omega * Math.sin(omega * t));
  return {
    columns: [
      column("external", x.map((s) => 1000 + m * g * s)),
      column("kinetic", v.map((s) => 0.5 * m * s * s)),
      column("elastic", x.map((s) => 400 + 0.5 * k * s * s)),
      column("plastic", times.map(() => 70)),
      column("damping", times.map((t) => 30 - lost * t)),
    ],
  };
}

test("a weight on a spring keeps its energy, whatever the budgets were before", () => {
  const { residual, work } = findEnergyBalance(makeOscillator(0))!;
  for (const r of residual) expect(Math.abs(r!)).toBeLessThan(1e-12 * 1000);
  // The weight sinks by 2mg/k at most.
  expect(work).toBeCloseTo((2 * (2 * 9.81) ** 2) / 300, 1);
});

test("damping that is missing from its column appears as residual, with its sign", () => {
  const { residual } = findEnergyBalance(makeOscillator(5))!;
  residual.forEach((r, i) => expect(r).toBeCloseTo(5 * times[i]!, 9));
});

test("what walls take and what is lost between points and nodes belong to the balance", () => {
  const table = makeOscillator(5);
  table.columns.push(column("walls", times.map((t) => 3 * t)), column("mapping", times.map((t) => 7 + 2 * t)));
  findEnergyBalance(table)!.residual.forEach((r) => expect(Math.abs(r!)).toBeLessThan(1e-9));
});

test("no balance without all columns, none in a row with a gap", () => {
  const table = makeOscillator(0);
  expect(findEnergyBalance({ columns: table.columns.slice(0, 4) })).toBeNull();
  table.columns[2]!.values[7] = null;
  const { residual } = findEnergyBalance(table)!;
  expect(residual[7]).toBeNull();
  expect(residual[8]).not.toBeNull();
});
