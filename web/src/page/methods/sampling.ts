// SPDX-License-Identifier: MIT
/** Paragraph on uncertain numbers. */
import type { Writer } from "./writer";

export const writeSampling: Writer = ({ study_result: study }) => {
  const sampling = study?.sampling;
  if (!sampling) return [];
  const drawn =
    sampling.plan === "random"
      ? "drawn independently at random"
      : "drawn as a Latin hypercube [@mckay1979]: each number takes every one of as many equally probable parts of its " +
        "range once";
  const correlated = sampling.correlations.length
    ? " Correlations hold for the normal scores of the numbers."
    : " The numbers are independent of each other.";
  return [
    {
      text:
        `Uncertain numbers were ${drawn}.${correlated} The probability of failure is the share of samples with a factor ` +
        "below 1, and its interval that of Clopper and Pearson [@clopper1934],",
    },
    {
      tex: "P_f=P(F<1)\\approx\\frac{n_{F<1}}n,\\qquad \\beta=-\\Phi^{-1}(P_f)",
      plain: "P_f = P(F < 1) ≈ n_(F<1) / n,  β = −Φ⁻¹(P_f)",
    },
    ...(sampling.design_point || sampling.first_order
      ? [
          {
            text:
              "Beside it stand estimates that need few factors: the first order in the scatter at the means, and the " +
              "most probable values at failure, whose distance from the means in standard normal space is Hasofer and " +
              "Lind's index [@hasofer1974]. They see one failure region and a limit that is nearly plane.",
          },
        ]
      : []),
    {
      text: "The seed and the case give the same samples again.",
    },
  ];
};
