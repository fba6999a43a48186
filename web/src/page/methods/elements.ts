// SPDX-License-Identifier: MIT
/** Paragraphs on finite elements, limit analysis, uncertain numbers and partial factors. */
import { quoteNumber } from "./settings";
import { prose, type MethodTexts } from "./writer";

export const elements = {
  finite_elements: ["Finite elements", ({ result: { fem } }) => {
    const solid = fem?.element === "T10";
    return prose`
      The ground was divided into quadratic ${solid ? "tetrahedra of ten" : "triangles of six"} nodes; unlike linear
      ones they do not lock in plastic flow at constant volume. Displacements are small, and the state is one of static
      equilibrium,
      $$\int\mathbf B^{T}\boldsymbol\sigma\,dV=\mathbf f^{\,ext}$$ ∫ Bᵀ σ dV = f_ext $$
      solved by Newton's method with the consistent tangent of the soil models, a sparse direct solver and line search;
      weight and loads come on in steps. Total stress is effective stress less pore pressure.`;
  }],
  finite_element_reduction: ["Strength reduction by FEM", ({ result: { input, fem } }) => {
    const both = (fem?.runs.length ?? 0) > 1;
    return prose`
      From the equilibrium at full strength, strength was divided by $F$ [@griffiths1999]. A trial is in equilibrium
      when both residuals are small: the unbalanced force, over the external force, below
      ${quoteNumber(input, "fem.force_tolerance", "$10^{-4}$")}, and the last correction of the displacements, over
      their size, below ${quoteNumber(input, "fem.displacement_tolerance", "$10^{-4}$")}. The second alone would always
      be met after enough iterations. The interval between the largest factor with equilibrium and the smallest without
      was halved to ${quoteNumber(input, "fem.resolution", "0.005")}; its middle is the factor. The other criterion is
      the knee of the curve of displacement over $F$.

      ${
        both
          ? "This was done with the dilatancy angle as given and with $\\psi=\\varphi$, which LEM and limit analysis " +
            "assume in effect. "
          : ""
      }The slip surface is the ridge of the shear strain between the moving mass and the rest, at the smallest factor without
      equilibrium.`;
  }],
  limit_analysis: ["Limit analysis", () => prose`
    The factor of safety of rigid, perfectly plastic soil with $\psi=\varphi$ was enclosed by limit analysis
    [@drucker1952; @lyamin2002]. The lower bound is a field of stresses, linear in triangles and in equilibrium inside,
    across every edge and with the loads, that nowhere exceeds the strength divided by $F$,
    $$\sqrt{\tfrac14(\sigma'_x-\sigma'_y)^2+\tau_{xy}^2}\le\frac
    cF\cos\varphi_F-\tfrac12(\sigma'_x+\sigma'_y)\sin\varphi_F,\qquad\tan\varphi_F=\frac{\tan\varphi}F$$
    √(¼ (σ'x − σ'y)² + τxy²) ≤ c/F cos φ_F − ½ (σ'x + σ'y) sin φ_F, tan φ_F = tan φ/F $$
    which holds everywhere once it holds at the corners. The upper bound is a field of velocities, quadratic in
    triangles, that obeys the flow rule at their corners, and whose loads do more work than the soil with its strength
    divided by $F$ can take up. Both are second-order cone programs for the least cohesion that every place lacks,
    solved by an interior point method; $F$ is where nothing lacks. Triangles are halved where the two fields disagree.
    What is printed was computed from the fields alone: stresses brought into equilibrium, velocities into the flow
    rule, and checked.`],
  sampling: ["Uncertain numbers", ({ study_result: study }) => {
    const sampling = study?.sampling;
    if (!sampling) return "";
    const drawn =
      sampling.plan === "random"
        ? "drawn independently at random"
        : "drawn as a Latin hypercube [@mckay1979]: each number takes every one of as many equally probable parts of " +
          "its range once";
    const correlated = sampling.correlations.length
      ? " Correlations hold for the normal scores of the numbers."
      : " The numbers are independent of each other.";
    return prose`
      Uncertain numbers were ${drawn}.${correlated} The probability of failure is the share of samples with a factor
      below 1, and its interval that of Clopper and Pearson [@clopper1934],
      $$P_f=P(F<1)\approx\frac{n_{F<1}}n,\qquad \beta=-\Phi^{-1}(P_f)$$ P_f = P(F < 1) ≈ n_(F<1) / n,  β = −Φ⁻¹(P_f) $$

      ${sampling.design_point || sampling.first_order ? prose`
      Beside it stand estimates that need few factors: the first order in the scatter at the means, and the most
      probable values at failure, whose distance from the means in standard normal space is Hasofer and Lind's index
      [@hasofer1974]. They see one failure region and a limit that is nearly plane.` : ""}

      The seed and the case give the same samples again.`;
  }],
  partial_factors: ["Partial factors", ({ result }) => prose`
    Strengths, weights and loads are design
    values${result.methods?.partial_factors?.set ? ` (${result.methods.partial_factors.set})` : ""} after Eurocode 7
    [@en1997]: characteristic values with the partial factors of the table above. The factor of safety that is found
    with them is the over-design factor; the slope is verified where it is 1 or more.`],
} satisfies MethodTexts;
