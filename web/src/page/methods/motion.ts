// SPDX-License-Identifier: MIT
/** Paragraphs on the material point method itself; the formulas are those of the theory pages of the manual. */
import { isOnAnywhere, quoteEach } from "./settings";
import type { Block, Writer } from "./writer";

export const writeMaterialPoints: Writer = ({ model, methods, result: { input } }) => {
  const phases = methods.includes("two_phase")
    ? "Where the soil holds water this balance is that of soil and water together, and the water has one of its own, " +
      "below"
    : methods.includes("seeping")
      ? "Where the soil holds water this balance is that of soil and water together, which have one velocity"
      : "The soil is a single phase";
  const simplex = model.dimension === 2 ? "triangles" : "tetrahedra";
  const plane =
    model.dimension === 2
      ? " The analysis is in plane strain, with all quantities per metre of thickness; the stress normal to the " +
        "plane takes part in yielding."
      : "";
  const rotation =
    isOnAnywhere(input, "objective_rate") === false
      ? [{ text: "Stress increments are added in fixed axes; stresses are not turned with the soil." }]
      : [
          {
            text:
              "Before each increment the stress is turned with the soil by the rotation of the step, in the form " +
              "of Hughes and Winget [@hughes1980], with $\\mathbf L=\\sum_i\\,\\mathbf v_i\\otimes\\nabla N_i$:",
          },
          {
            tex:
              "\\boldsymbol\\sigma\\leftarrow\\mathbf R\\,\\boldsymbol\\sigma\\,\\mathbf R^{\\mathsf T},\\quad " +
              "\\mathbf R=\\left(\\mathbf I-\\tfrac12\\mathbf W\\right)^{-1}\\left(\\mathbf I+" +
              "\\tfrac12\\mathbf W\\right),\\quad " +
              "\\mathbf W=\\tfrac12\\Delta t\\,(\\mathbf L-\\mathbf L^{\\mathsf T})",
            plain: "σ ← R σ Rᵀ,  R = (I − W/2)⁻¹ (I + W/2),  W = ½ Δt (L − Lᵀ)",
          },
        ];
  return [
    {
      text:
        "The motion of the soil was computed with the material point method [@sulsky1994]. The soil is " +
        "represented by material points, which carry mass, velocity, stress and state through a fixed background " +
        `mesh of linear ${simplex}.${plane} ${phases}; stresses are Cauchy stresses, positive in ` +
        "tension. In each explicit time step the balance of momentum is solved at the nodes $i$ of the mesh, with " +
        "a lumped mass matrix, from sums over the points $p$ [@source]:",
    },
    {
      tex:
        "m_i\\,\\mathbf a_i=\\mathbf f_i^{\\,ext}-\\mathbf f_i^{\\,int},\\quad m_i=\\sum_p m_pN_i,\\quad " +
        "\\mathbf f_i^{\\,ext}=\\sum_p m_pN_i\\,\\mathbf g+\\int_{\\partial\\Omega^{\\tau}}N_i\\," +
        "\\hat{\\boldsymbol\\tau}\\,dS,\\quad " +
        "\\mathbf f_i^{\\,int}=\\sum_p V_p\\,\\boldsymbol\\sigma_p\\nabla N_i",
      plain:
        "m_i a_i = f_i^ext − f_i^int,  m_i = Σ_p m_p N_i,  f_i^ext = Σ_p m_p N_i g + ∫ N_i τ dS,  f_i^int = Σ_p " +
        "V_p σ_p ∇N_i",
    },
    {
      text:
        "The step is “modified update stress last” [@sulsky1995]: velocities of points are changed by nodal " +
        "accelerations only; nodal velocities are formed anew from them, and move and strain the points:",
    },
    {
      tex:
        "\\mathbf v_p\\leftarrow\\mathbf v_p+\\Delta t\\sum_iN_i\\mathbf a_i,\\quad " +
        "m_i\\mathbf v_i=\\sum_pm_pN_i\\mathbf v_p,\\quad " +
        "\\mathbf x_p\\leftarrow\\mathbf x_p+\\Delta t\\sum_iN_i\\mathbf v_i,\\quad " +
        "\\Delta\\boldsymbol\\varepsilon=\\tfrac12\\Delta t" +
        "\\sum_i(\\mathbf v_i\\otimes\\nabla N_i+\\nabla N_i\\otimes\\mathbf v_i)",
      plain:
        "v_p ← v_p + Δt Σ_i N_i a_i,  m_i v_i = Σ_p m_p N_i v_p,  x_p ← x_p + Δt Σ_i N_i v_i,  Δε = ½ Δt Σ_i (v_i " +
        "⊗ ∇N_i + ∇N_i ⊗ v_i)",
    },
    ...rotation,
  ];
};

/** The time step of the two-velocity formulation has another limit. */
const wetStep: Block[] = [
  {
    text:
      "Where pore water flows, the step is that of the frictionless waves of both phases, which implicit drag can " +
      "only lengthen (explicit drag shortens it further). With $\\lambda=4/L_e^2$ it is the smallest root of",
  },
  {
    tex:
      "\\det\\left(4\\beta\\mathbf M-\\Delta t^2\\lambda\\mathbf K\\right)=0,\\quad " +
      "\\mathbf M=\\begin{bmatrix}(1-n)\\rho_s&\\\\&\\theta\\rho_w\\end{bmatrix},\\quad " +
      "\\mathbf K=\\begin{bmatrix}E_c&\\\\&0\\end{bmatrix}+\\frac{S^2}{n(S/K_w-dS/dp)}" +
      "\\begin{bmatrix}1-n\\\\n\\end{bmatrix}\\begin{bmatrix}1-n&n\\end{bmatrix}",
    plain:
      "det(4 β M − Δt² λ K) = 0,  M = diag((1 − n) ρ_s, θ ρ_w),  K = diag(E_c, 0) + S² / (n (S/K_w − dS/dp)) [1 − n, " +
      "n]ᵀ [1 − n, n]",
  },
];

export const writeTimeStep: Writer = ({ model, methods, result: { input } }) => {
  const courant = quoteEach(input, "courant");
  return [
    {
      text:
        "The time step is a share $C$ (the Courant number) of the time in which a compression wave crosses " +
        "the smallest element:",
    },
    {
      tex:
        "\\Delta t=C\\,\\min_e\\frac{L_e}{c_e},\\qquad c_e=\\sqrt{\\frac{E_c}{\\beta\\rho}},\\qquad " +
        "E_c=\\frac{E(1-\\nu)}{(1+\\nu)(1-2\\nu)}",
      plain: "Δt = C min_e (L_e / c_e),  c_e = √(E_c / (β ρ)),  E_c = E (1 − ν) / ((1 + ν)(1 − 2ν))",
    },
    {
      text:
        `Here $L_e$ is the smallest altitude of the ${model.dimension === 2 ? "triangle" : "tetrahedron"}, ` +
        "$\\rho$ the present density, and $\\beta$ the " +
        "mass scaling, 1 unless stated; the minimum is taken over elements that hold soil and their " +
        "neighbours, and is found again as the soil moves." +
        (courant ? ` The Courant number was ${courant}.` : ""),
    },
    ...(methods.includes("two_phase") ? wetStep : []),
  ];
};

export const writeDamping: Writer = ({ result: { input } }) => {
  const damping = quoteEach(input, "damping");
  return [
    {
      text:
        "Local damping after Cundall [@itasca] acts at every node and in every direction against the motion, in " +
        "proportion to the unbalanced force:",
    },
    {
      tex:
        "\\mathbf f_i^{\\,damp}=-\\alpha\\,\\operatorname{sign}(\\mathbf p_i)\\," +
        "\\bigl|\\mathbf f_i^{\\,ext}-\\mathbf f_i^{\\,int}\\bigr|,\\qquad " +
        "\\mathbf p_i=\\sum_pm_pN_i\\mathbf v_p",
      plain: "f_i^damp = −α sign(p_i) |f_i^ext − f_i^int|,  p_i = Σ_p m_p N_i v_p",
    },
    {
      text:
        "It is added to the right side of the balance of momentum. It vanishes with the unbalanced force and " +
        "so does not change a state of rest; during " +
        "motion it takes energy out of the soil." +
        (damping ? ` The damping $\\alpha$ was ${damping}.` : ""),
    },
  ];
};

export const writeMassScaling: Writer = ({ result: { input } }) => {
  const scaling = quoteEach(input, "mass_scaling");
  return [
    { text: "To settle the soil in fewer steps its inertia, and only that, was multiplied by a factor $\\beta$:" },
    {
      tex: "\\mathbf a_i=\\frac{\\mathbf f_i}{\\beta\\,m_i},\\qquad \\Delta t_{cr}\\propto\\sqrt\\beta",
      plain: "a_i = f_i / (β m_i),  Δt_cr ∝ √β",
    },
    {
      text:
        "Weight and momentum keep the real masses. States of rest are not affected; velocities during the " +
        "scaled stages are not real." +
        (scaling ? ` The factor $\\beta$ was ${scaling}.` : ""),
    },
  ];
};

export const writeRunout: Writer = () => [
  {
    text:
      "The runout was computed on moving geometry, and compares the soil at the end with the state from which " +
      "displacements are counted. Soil counts as moved where its displacement exceeds 1 % of $H$, the height of " +
      "the slope. The front is the coordinate behind which 99 % of the moved mass lies:",
  },
  {
    tex:
      "\\text{advance}=Q_{0.99}\\bigl(s_p\\bigr)-Q_{0.99}\\bigl(s_p^{\\,0}\\bigr),\\qquad " +
      "V=\\sum_{p\\,:\\,|\\mathbf u_p|>0.01H}V_p",
    plain: "advance = Q99(s_p) − Q99(s_p at the start),  V = Σ V_p over points with |u_p| > 0.01 H",
  },
  {
    text:
      "with $Q_{0.99}$ the 99 % quantile by mass of the positions $s_p$ of the moved points along the direction " +
      "of motion. The retreat of the crest is how far behind the crest the rearmost moved point began. The " +
      "results say whether the soil had come to rest when the calculation ended.",
  },
];
