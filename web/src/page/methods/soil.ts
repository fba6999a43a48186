// SPDX-License-Identifier: MIT
/** Paragraphs on integration, smoothing and the soil models; formulas as in the theory pages of the manual. */
import type { Block, Writer } from "./writer";

const nodalAverage: Block = {
  tex:
    "\\Delta\\bar\\varepsilon_{vol,i}=\\frac{\\sum_{e\\ni i}\\Delta\\varepsilon_{vol,e}V_e}{" +
    "\\sum_{e\\ni i}V_e},\\qquad " +
    "\\Delta\\bar\\varepsilon_{vol,e}=\\frac1{D+1}\\sum_{i\\in e}\\Delta\\bar\\varepsilon_{vol,i},\\qquad " +
    "\\Delta\\boldsymbol\\varepsilon\\leftarrow\\Delta\\boldsymbol\\varepsilon+\\tfrac13\\left(" +
    "\\Delta\\bar\\varepsilon_{vol,e}-\\Delta\\varepsilon_{vol,e}\\right)\\mathbf I",
  plain:
    "Δε̄_vol,i = Σ_e Δε_vol,e V_e / Σ_e V_e (elements e at node i),  Δε̄_vol,e = Σ_i Δε̄_vol,i / (D + 1) (nodes i " +
    "of e),  Δε ← Δε + ⅓ (Δε̄_vol,e − Δε_vol,e) I",
};

export const writeMixedIntegration: Writer = () => [
  {
    text:
      "Internal forces were integrated in the mixed way [@source]: elements that are full of soil of one material " +
      "as in finite elements with one Gauss point, from the mean of the stresses of their points; all others over " +
      "the material points:",
  },
  {
    tex:
      "\\mathbf f_i^{\\,int}=\\begin{cases}V_e\\,\\bar{\\boldsymbol\\sigma}_e\\nabla N_i,\\quad " +
      "\\bar{\\boldsymbol\\sigma}_e=\\dfrac{\\sum_pV_p\\boldsymbol\\sigma_p}{\\sum_pV_p}&" +
      "\\text{full element}\\\\[1ex]\\sum_pV_p\\,\\boldsymbol\\sigma_p\\nabla N_i&\\text{otherwise}\\end{cases}",
    plain:
      "f_i^int = V_e σ̄_e ∇N_i with σ̄_e = Σ_p V_p σ_p / Σ_p V_p in a full element;  f_i^int = Σ_p V_p σ_p ∇N_i " +
      "otherwise",
  },
  {
    text:
      "An element is full inside the soil, and at the free surface when the volume of its points exceeds 90 % of " +
      "its own. The points of a full element share one state. Integration over the whole element does not " +
      "conserve energy exactly.",
  },
];

export const writePointIntegration: Writer = () => [
  { text: "Internal forces were integrated over the material points in every element [@sulsky1994]:" },
  {
    tex: "\\mathbf f_i^{\\,int}=\\sum_pV_p\\,\\boldsymbol\\sigma_p\\nabla N_i",
    plain: "f_i^int = Σ_p V_p σ_p ∇N_i",
  },
  {
    text:
      "The force of a point jumps to other nodes when it crosses a side of the mesh, which shows as noise in " +
      "the stresses.",
  },
];

export const writeStrainSmoothing: Writer = () => [
  {
    text:
      "Volumetric locking of the linear elements was reduced by averaging the volumetric strain increment over " +
      "the nodes and back, as in nodal mixed discretisation [@detournay2006], over elements that hold soil:",
  },
  nodalAverage,
  {
    text:
      "$D$ is the dimension; the deviatoric part is not changed. With dilatancy this plain form can grow " +
      "unstable; it is meant for a dilatancy angle of zero.",
  },
];

export const writeStableSmoothing: Writer = ({ methods }) => [
  ...(methods.includes("strain_smoothing")
    ? [
        {
          text:
            "Where the stable form of smoothing was used, the volumetric strain increment was averaged in the " +
            "same way.",
        },
      ]
    : [
        {
          text:
            "Volumetric locking of the linear elements was removed by averaging the volumetric strain increment " +
            "over the nodes and back, as in nodal mixed discretisation [@detournay2006], over elements that hold " +
            "soil ($D$ is the dimension):",
        },
        nodalAverage,
      ]),
  {
    text:
      "In addition the change of mean stress by the plastic return, $\\Delta p^r$, is averaged in the same way " +
      "(mean over the element, to the nodes, and back), and each element receives the difference. Without it the " +
      "averaged strain and the return in answer to shear do not balance within an element where the soil dilates:",
  },
  {
    tex:
      "\\boldsymbol\\sigma_p\\leftarrow\\boldsymbol\\sigma_p+\\left(\\Delta\\bar p^{\\,r}_e-" +
      "\\Delta p^{\\,r}_e\\right)\\mathbf I,\\qquad " +
      "\\Delta p^{\\,r}=p(\\boldsymbol\\sigma^{new})-p(\\boldsymbol\\sigma^{tr})",
    plain: "σ_p ← σ_p + (Δp̄ʳ_e − Δpʳ_e) I,  Δpʳ = p(σ_new) − p(σ_trial)",
  },
];

export const writeMohrCoulomb: Writer = () => [
  {
    text:
      "The soil is linear elastic and perfectly plastic, with Mohr–Coulomb strength, plastic flow by the " +
      "dilatancy angle, and a tension cut-off. With principal stresses $\\sigma_1\\ge\\sigma_2\\ge\\sigma_3$, " +
      "positive in tension, the yield function, the plastic potential and the cut-off are",
  },
  {
    tex:
      "f=k\\,\\sigma_1-\\sigma_3-2c\\sqrt k,\\quad k=\\frac{1+\\sin\\,\\varphi}{1-\\sin\\,\\varphi};\\qquad " +
      "g=m\\,\\sigma_1-\\sigma_3,\\quad m=\\frac{1+\\sin\\,\\psi}{1-\\sin\\,\\psi};\\qquad f_t=\\sigma_1-\\sigma_t",
    plain:
      "f = k σ_1 − σ_3 − 2 c √k,  k = (1 + sin φ)/(1 − sin φ);  g = m σ_1 − σ_3,  m = (1 + sin ψ)/(1 − sin ψ);  " +
      "f_t = σ_1 − σ_t",
  },
  {
    text:
      "with cohesion $c$, friction angle $\\varphi$, dilatancy angle $\\psi$ and tensile strength $\\sigma_t$, " +
      "which is at most $c/\\tan\\,\\varphi$. The elastic trial stress is returned in principal stresses to the " +
      "plane, edge or apex that is active [@clausen2007]; the flow of the cut-off is associated.",
  },
];

export const writeLinearElastic: Writer = () => [
  { text: "Where the materials are linear elastic, the stress follows Hooke’s law and has no limit:" },
  {
    tex:
      "\\Delta\\boldsymbol\\sigma=\\lambda\\,\\operatorname{tr}(" +
      "\\Delta\\boldsymbol\\varepsilon)\\,\\mathbf I+2\\mu\\,\\Delta\\boldsymbol\\varepsilon,\\quad " +
      "\\lambda=\\frac{E\\nu}{(1+\\nu)(1-2\\nu)},\\quad \\mu=\\frac{E}{2(1+\\nu)}",
    plain: "Δσ = λ tr(Δε) I + 2 μ Δε,  λ = E ν / ((1 + ν)(1 − 2ν)),  μ = E / (2 (1 + ν))",
  },
];
