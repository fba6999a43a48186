// SPDX-License-Identifier: MIT
/** Row numbers in the order of a column; rows without a value come last in both directions. */
export function orderValues(values: readonly (number | string | null)[], down: boolean): number[] {
  const sign = down ? -1 : 1;
  return Array.from(values.keys()).sort((a, b) => {
    const [x, y] = [values[a] ?? null, values[b] ?? null];
    if (x === null || y === null) return Number(x === null) - Number(y === null) || a - b;
    const difference =
      typeof x === "number" && typeof y === "number" ? x - y : String(x).localeCompare(String(y), "en");
    return sign * difference || a - b;
  });
}
