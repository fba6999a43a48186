// SPDX-License-Identifier: MIT
/** contract/report.schema.json agrees with src/contract/: the C++ tests check their output against that file. */
import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { createGenerator } from "ts-json-schema-generator";
import { expect, it } from "vitest";

const inWeb = (path: string) => fileURLToPath(new URL(`../${path}`, import.meta.url));

it("contract/report.schema.json is up to date (else: npm run schema)", () => {
  const generator = createGenerator({
    path: inWeb("src/contract/report.ts"),
    type: "ReportDocument",
    tsconfig: inWeb("tsconfig.json"),
  });
  const generated = JSON.parse(JSON.stringify(generator.createSchema("ReportDocument")));
  expect(JSON.parse(readFileSync(inWeb("contract/report.schema.json"), "utf8"))).toEqual(generated);
});
