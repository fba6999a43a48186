// SPDX-License-Identifier: MIT
// The order of the pages. A page of docs/ that is not named here is still built, and found by the search.
import { existsSync, readdirSync } from "node:fs";

const manual = [
  ["Start", ["docs/README.md", "docs/manual/install.md", "docs/manual/getting-started.md", "docs/manual/tutorial.md"]],
  [
    "How to",
    [
      "docs/manual/how-to/README.md",
      "docs/manual/how-to/publish-a-factor.md",
      "docs/manual/how-to/three-methods.md",
      "docs/manual/how-to/reproduce-a-curve.md",
      "docs/manual/how-to/run-a-slide.md",
      "docs/manual/how-to/section-from-cad.md",
      "docs/manual/how-to/layers-and-boreholes.md",
      "docs/manual/how-to/ready-mesh.md",
      "docs/manual/how-to/soil-water-curves.md",
      "docs/manual/how-to/rain-on-a-slope.md",
      "docs/manual/how-to/factor-in-time.md",
      "docs/manual/how-to/lower-a-reservoir.md",
      "docs/manual/how-to/rapid-drawdown.md",
      "docs/manual/how-to/season.md",
      "docs/manual/how-to/roots.md",
      "docs/manual/how-to/element-tests.md",
      "docs/manual/how-to/calibrate.md",
      "docs/manual/how-to/external-model.md",
      "docs/manual/how-to/follow-points.md",
      "docs/manual/how-to/study-a-parameter.md",
      "docs/manual/how-to/probability.md",
      "docs/manual/how-to/larger-than-one-machine.md",
      "docs/manual/how-to/eurocode-7.md",
      "docs/manual/how-to/compare-plantings.md",
      "docs/manual/how-to/mesh-and-speed.md",
      "docs/manual/how-to/resume.md",
      "docs/manual/how-to/compare.md",
      "docs/manual/how-to/sign.md",
    ],
  ],
  [
    "Manual",
    [
      "docs/manual/studio.md",
      "docs/manual/case-file.md",
      "docs/manual/command-line.md",
      "docs/manual/study.md",
      "docs/manual/results.md",
      "docs/manual/report.md",
      "docs/manual/paraview.md",
      "docs/manual/python.md",
      "docs/manual/strength-reduction.md",
      "docs/manual/modelling-advice.md",
      "docs/manual/troubleshooting.md",
    ],
  ],
];

const rest = [
  ["Verification", ["docs/verification.md", "docs/performance.md", "docs/reliability.md"]],
  [
    "How it is built",
    [
      "docs/architecture.md",
      "docs/decisions/README.md",
      "CONTRIBUTING.md",
      "RELEASING.md",
      "CHANGELOG.md",
    ],
  ],
];

/** Sections of the navigation: [name, sources of pages]. Pages that do not exist (yet) are left out. */
export function sections(referencePages) {
  const theory = readdirSync("docs/theory")
    .filter((name) => name.endsWith(".md"))
    .sort();
  const all = [
    ...manual,
    ["Reference", referencePages.map((page) => page.source)],
    ["Theory", [...theory.map((name) => `docs/theory/${name}`), "docs/notation.md"]],
    ...rest,
  ];
  const made = new Set(["docs/decisions/README.md", ...referencePages.map((page) => page.source)]);
  return all.map(([name, sources]) => [name, sources.filter((source) => made.has(source) || existsSync(source))]);
}

/** Markdown outside docs/ that becomes pages as well. */
export function outsidePages() {
  return ["CHANGELOG.md", "CONTRIBUTING.md", "RELEASING.md", ...listReadmes("examples")].filter((source) => existsSync(source));
}

function listReadmes(folder) {
  const below = readdirSync(folder, { withFileTypes: true }).filter((entry) => entry.isDirectory());
  return [`${folder}/README.md`, ...below.map((entry) => `${folder}/${entry.name}/README.md`)];
}
