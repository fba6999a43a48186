// SPDX-License-Identifier: MIT
/** Paragraph on limit analysis. */
import type { Writer } from "./writer";

export const writeLimitAnalysis: Writer = () => [
  {
    text:
      "The factor of safety of rigid, perfectly plastic soil with $\\psi=\\varphi$ was enclosed by limit analysis " +
      "[@drucker1952; @lyamin2002]. The lower bound is a field of stresses, linear in triangles and in equilibrium inside, across every " +
      "edge and with the loads, that nowhere exceeds the strength divided by $F$,",
  },
  {
    tex: "\\sqrt{\\tfrac14(\\sigma'_x-\\sigma'_y)^2+\\tau_{xy}^2}\\le\\frac cF\\cos\\varphi_F-\\tfrac12(\\sigma'_x+\\sigma'_y)\\sin\\varphi_F,\\qquad\\tan\\varphi_F=\\frac{\\tan\\varphi}F",
    plain: "√(¼ (σ'x − σ'y)² + τxy²) ≤ c/F cos φ_F − ½ (σ'x + σ'y) sin φ_F, tan φ_F = tan φ/F",
  },
  {
    text:
      "which holds everywhere once it holds at the corners. The upper bound is a field of velocities, quadratic in " +
      "triangles, that obeys the flow rule at their corners, and whose loads do more work than the soil with its strength divided by " +
      "$F$ can take up. Both are second-order cone programs for the least cohesion that every place lacks, solved by an " +
      "interior point method; $F$ is where nothing lacks. Triangles are halved where the two fields disagree. What is printed was " +
      "computed from the fields alone: stresses brought into equilibrium, velocities into the flow rule, and checked.",
  },
];
