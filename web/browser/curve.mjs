// SPDX-License-Identifier: MIT
// The curve's CSV, as it is downloaded from the page, is the curve.csv of the results.
import { existsSync, readFileSync } from "node:fs";
import { join } from "node:path";

import { readCsv } from "./results.mjs";

const title = "Displacement over strength reduction factor";

export async function checkCurve(list, page, folder, out) {
  const region = page.getByRole("region", { name: title });
  await region.first().scrollIntoViewIfNeeded();
  await page.waitForTimeout(400);
  await region.first().screenshot({ path: join(out, "curve.png") });
  const downloading = page.waitForEvent("download");
  await region.getByRole("button", { name: "Download CSV" }).first().click();
  const download = await downloading;
  const path = join(out, "curve.csv");
  await download.saveAs(path);
  list.expect(download.suggestedFilename().endsWith(".csv"), `the download is called ${download.suggestedFilename()}`);
  const original = join(folder, "curve.csv");
  if (!existsSync(original)) return list.note("no curve.csv in the results folder to compare with");
  const [expected, got] = [original, path].map((file) => readCsv(readFileSync(file, "utf8")));
  const rows = `${got.length}, not ${expected.length}`;
  list.expect(got.length === expected.length, "the CSV has a row for every trial", rows);
  const header = (table) => table[0].map((name) => String(name).toLowerCase());
  for (const [column, name] of header(expected).entries()) {
    const place = header(got).findIndex((other) => other.split(" [")[0] === name.split(" [")[0]);
    if (!list.expect(place >= 0, `the CSV has the column '${name}'`, header(got).join(", "))) continue;
    const unit = (text) => /\[(.*)\]/.exec(text)?.[1] ?? "-";
    list.expect(unit(header(got)[place]) === unit(name), `its unit is ${unit(name)}`, header(got)[place]);
    const differs = expected.slice(1).findIndex((row, i) => {
      const other = got[i + 1]?.[place];
      if (typeof row[column] !== "number") return row[column] !== other;
      return !(Math.abs(row[column] - other) <= 1e-12 * Math.abs(row[column]));
    });
    list.expect(differs < 0, `its values are those of curve.csv`, `row ${differs + 1}`);
  }
}
