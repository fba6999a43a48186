// SPDX-License-Identifier: MIT
/** Paragraphs on FEM. */
import { quoteNumber } from "./settings";
import type { Writer } from "./writer";

export const writeFiniteElements: Writer = ({ result: { fem } }) => {
  const solid = fem?.element === "T10";
  return [
    {
      text:
        `The ground was divided into quadratic ${solid ? "tetrahedra of ten" : "triangles of six"} nodes; unlike linear ` +
        "ones they do not lock in plastic flow at constant volume. Displacements are small, and the state is one of " +
        "static equilibrium,",
    },
    {
      tex: "\\int\\mathbf B^{T}\\boldsymbol\\sigma\\,dV=\\mathbf f^{\\,ext}",
      plain: "∫ Bᵀ σ dV = f_ext",
    },
    {
      text:
        "solved by Newton's method with the consistent tangent of the soil models, a sparse direct solver and line " +
        "search; weight and loads come on in steps. Total stress is effective stress less pore pressure.",
    },
  ];
};

export const writeElementReduction: Writer = ({ result: { input, fem } }) => {
  const both = (fem?.runs.length ?? 0) > 1;
  return [
    {
      text:
        "From the equilibrium at full strength, strength was divided by $F$ [@griffiths1999]. A trial is in " +
        "equilibrium when both residuals are small: the unbalanced force, over the external force, below " +
        `${quoteNumber(input, "fem.force_tolerance", "$10^{-4}$")}, and the last correction of the displacements, over ` +
        `their size, below ${quoteNumber(input, "fem.displacement_tolerance", "$10^{-4}$")}. The second alone would ` +
        "always be met after enough iterations. The interval between the largest factor with equilibrium and the " +
        `smallest without was halved to ${quoteNumber(input, "fem.resolution", "0.005")}; its middle is the factor. ` +
        "The other criterion is the knee of the curve of displacement over $F$.",
    },
    {
      text:
        (both
          ? "This was done with the dilatancy angle as given and with $\\psi=\\varphi$, which LEM and limit analysis assume in effect. "
          : "") +
        "The slip surface is the ridge of the shear strain between the moving mass and the rest, at the smallest " +
        "factor without equilibrium.",
    },
  ];
};
