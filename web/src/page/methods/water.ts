// SPDX-License-Identifier: MIT
/** Paragraphs on soil and pore water moving together; formulas as on the theory page on the two-phase step. */
import type { InputTable } from "../../contract";
import { findWords, isOnAnywhere, quoteEach, quoteWhere } from "./settings";
import type { Block, Writer } from "./writer";

/** The damping of the water, where there was some. */
function writeWaterDamping(input: InputTable): Block[] {
  if (!isOnAnywhere(input, "water_damping")) return [];
  const fraction = quoteEach(input, "water_damping");
  return [{ text: `Local damping acts on the water as well, against its motion; its share was ${fraction}.` }];
}

export const writeTwoPhase: Writer = ({ result: { input } }) => {
  const explicit = quoteWhere(input, "drag", "explicit");
  const implicit = quoteWhere(input, "drag", "implicit") !== "" || !explicit;
  const differences = [
    implicit
      ? "with the difference of the velocities at the end of the step (implicit drag, solved in closed form at each " +
        "node), so that a low conductivity does not shorten the time step"
      : "",
    explicit ? `with that at its beginning (explicit drag)${implicit ? ` in ${explicit}` : ""}` : "",
  ].filter(Boolean);
  return [
    {
      text:
        "Soil and pore water were computed as two phases with a velocity each, $\\mathbf v$ of the grains and " +
        "$\\mathbf w$ of the water, on one set of points that go with the grains [@source; @alkafaji2013; " +
        "@ceccato2021]. Air is at atmospheric pressure. The pore pressure $p$ is counted like all stresses of " +
        "these equations, positive in tension: $p>0$ is suction. With the porosity $n$, the degree of saturation " +
        "$S$ and the content of water $\\theta=nS$ the balances of momentum of water and of mixture are",
    },
    {
      tex:
        "\\rho_w\\mathbf a_w=\\operatorname{grad}p+\\rho_w\\mathbf g-\\frac{\\rho_wg}k\\,\\theta(\\mathbf " +
        "w-\\mathbf v)," +
        "\\qquad (1-n)\\rho_s\\mathbf a_s+\\theta\\rho_w\\mathbf a_w=\\operatorname{div}\\left(" +
        "\\boldsymbol\\sigma'+\\chi p\\,\\mathbf I\\right)+\\rho\\,\\mathbf g",
      plain: "ρ_w a_w = grad p + ρ_w g − (ρ_w g / k) θ (w − v),  (1 − n) ρ_s a_s + θ ρ_w a_w = div(σ′ + χ p I) + ρ g",
    },
    {
      text:
        "with $k$ the conductivity and $\\rho=(1-n)\\rho_s+\\theta\\rho_w$. Without relative acceleration the first " +
        "is Darcy's law. At the nodes $i$, with sums over points,",
    },
    {
      tex:
        "\\beta M_w\\mathbf a_w=\\mathbf F_w-\\theta_iR\\,(\\mathbf w^*-\\mathbf v^*),\\qquad " +
        "\\beta M_s\\mathbf a_s=\\mathbf F-\\theta_i\\mathbf F_w+\\theta_i^2R\\,(\\mathbf w^*-\\mathbf v^*)," +
        "\\qquad R=\\sum_p\\frac{\\rho_wg}{k_p}V_pN_i",
      plain:
        "β M_w a_w = F_w − θ_i R (w* − v*),  β M_s a_s = F − θ_i F_w + θ_i² R (w* − v*),  R = Σ_p (ρ_w g / k_p) " +
        "V_p N_i",
    },
    {
      text:
        "where $\\mathbf F_w$ and $\\mathbf F$ are the forces on the water, taken as if it filled the volume, and on " +
        "the mixture, $M_w=\\sum_p\\rho_wV_pN_i$, $M_s=\\sum_pm_pN_i$, and $\\theta_i$ is the mass of water at the " +
        `node over $M_w$. The drag was taken ${differences.join(", and ")}. Mass scaling $\\beta$ multiplies the ` +
        "inertia of both phases and no weight.",
    },
    ...writeWaterDamping(input),
  ];
};

export const writeSeeping: Writer = ({ methods, result: { input } }) => {
  const where = methods.includes("two_phase") ? quoteWhere(input, "water", "seeps") : "";
  return [
    {
      text:
        `Pore water seeps${where ? ` in ${where}` : ""}: grains and water have one velocity $\\mathbf v$, and water ` +
        "moves against the grains as Darcy's law says. The pore pressure $p$, counted positive in tension like all " +
        "stresses of these equations, is continuous, with a value at each node. The motion of the step is predicted " +
        "under the pressures of its start; those of its end are the ones at which pores and water agree:",
    },
    {
      tex:
        "\\left[C+P_\\tau+\\Delta t\\,L_K+\\tfrac{\\Delta t^2}{\\beta}B\\,M^{-1}B^{\\mathsf T}\\right]\\delta=" +
        "\\Delta t\\,B\\mathbf v^*-\\Delta t\\left(L_Kp+\\sum_eV_eK\\,\\nabla N_i\\cdot\\rho_w\\mathbf g\\right)+" +
        "\\Delta t\\,\\hat q+H(p)-W",
      plain:
        "[C + P_τ + Δt L_K + (Δt²/β) B M⁻¹ Bᵀ] δ = Δt B v* − Δt (L_K p + Σ_e V_e K ∇N_i · ρ_w g) + Δt q + H(p) − W",
    },
    {
      text:
        "Here $W$ is the water of a node's pores: its share of what the points carry, and water of its own, which fades " +
        "as the soil moves past it. $H(p)$ is what these pores hold, $C=-dH/dp$, " +
        "$L_K$ the conductance between nodes with $K=k/(\\rho_wg)$, $B$ the growth of pores by motion, $M$ the masses of soil and water, and " +
        "$\\hat q$ what leaves through the surface. $P_\\tau$ is a polynomial projection of the increments against " +
        "patterns that no node feels [@dohrmann2004]. The equation is solved by conjugate gradients; neither the " +
        "conductivity nor the stiffness of the water bounds the time step, which is that of the drained soil.",
    },
  ];
};

export const writeWaterStorage: Writer = () => [
  {
    text:
      "Each point carries the mass $m_w$ of its water. Water flows with the content of the nodes; the pore pressure " +
      "is then the one at which the pores hold their water:",
  },
  {
    tex:
      "m_w\\leftarrow m_w-\\rho_wV\\,\\Delta t\\,\\operatorname{div}\\left[\\theta(\\mathbf w-\\mathbf v)\\right]," +
      "\\qquad p:\\;S(p)\\,e^{-p/K_w}=\\frac{m_w}{\\rho_w\\left(V-m_p/\\rho_s\\right)}",
    plain: "m_w ← m_w − ρ_w V Δt div[θ (w − v)],  p: S(p) exp(−p / K_w) = m_w / (ρ_w (V − m_p / ρ_s))",
  },
  {
    text:
      "To first order this is the equation of storage, $C\\,dp=S\\,d\\varepsilon_{vol}+" +
      "\\operatorname{div}[\\theta(\\mathbf w-\\mathbf v)]\\,dt$ with $C=nS/K_w-n\\,dS/dp$, whose sum over steps " +
      "would " +
      "lose water at a wetting front. Porosity follows the volume of the point, $n=1-m_p/(\\rho_sV)$. The points of " +
      "a full element hold their water as one.",
  },
];

const retentionLaws: { [word: string]: Block[] } = {
  van_genuchten: [
    { text: "Retention after van Genuchten [@vangenuchten1980], over the suction $s=p>0$:" },
    {
      tex:
        "S=S_{min}+(S_{max}-S_{min})\\left[1+\\left(\\frac " +
        "s{p_{ref}}\\right)^{\\frac1{1-\\lambda}}\\right]^{-\\lambda}",
      plain: "S = S_min + (S_max − S_min) [1 + (s / p_ref)^(1 / (1 − λ))]^(−λ)",
    },
  ],
  linear: [
    { text: "Retention along a straight line from $S_{max}$ at no suction to $S_{min}$ at $s_{dry}$:" },
    {
      tex: "S=\\max\\left(S_{min},\\;S_{max}-(S_{max}-S_{min})\\frac s{s_{dry}}\\right)",
      plain: "S = max(S_min, S_max − (S_max − S_min) s / s_dry)",
    },
  ],
  exponential: [
    { text: "Exponential retention after Gardner [@gardner1958]:" },
    {
      tex: "S=S_{min}+(S_{max}-S_{min})\\,e^{-\\alpha s}",
      plain: "S = S_min + (S_max − S_min) exp(−α s)",
    },
  ],
  table: [{ text: "A table of measured pairs of suction and saturation was joined by monotone cubics." }],
  saturated: [{ text: "Soil with the retention “saturated” stays saturated at any suction." }],
};

const conductivityLaws: { [word: string]: Block[] } = {
  constant: [{ text: "A constant conductivity is that of the saturated soil at any suction." }],
  mualem: [
    { text: "Conductivity after Mualem [@mualem1976], with $X$ the (or, where stated, the effective) saturation:" },
    {
      tex: "k=k_s\\sqrt X\\left[1-\\left(1-X^{1/\\lambda}\\right)^{\\lambda}\\right]^2",
      plain: "k = k_s √X [1 − (1 − X^(1/λ))^λ]²",
    },
  ],
  hillel: [
    { text: "Conductivity as a power of the saturation $X$ [@hillel1971]:" },
    { tex: "k=k_s\\,X^{\\,r}", plain: "k = k_s X^r" },
  ],
  exponential: [
    { text: "Exponential conductivity after Gardner [@gardner1958]:" },
    { tex: "k=k_s\\,e^{-\\alpha s}", plain: "k = k_s exp(−α s)" },
  ],
};

export const writeSoilWater: Writer = ({ result: { input } }) => {
  const pick = (laws: { [word: string]: Block[] }, key: string) =>
    findWords(input, "materials", key).flatMap((word) => laws[word] ?? []);
  const khalili = findWords(input, "materials", "water.chi").includes("khalili_khabbaz");
  return [
    {
      text:
        "Strength and stiffness follow the effective stress of Bishop [@bishop1959], $\\boldsymbol\\sigma'=" +
        "\\boldsymbol\\sigma-\\chi p\\,\\mathbf I$ in the signs used here, with $\\chi=S$" +
        (khalili
          ? ", or after Khalili and Khabbaz [@khalili1998] with $\\chi=(s/s_e)^{-0.55}$ above the air entry $s_e$ " +
            "and 1 below it."
          : "."),
    },
    ...pick(retentionLaws, "water.retention"),
    ...pick(conductivityLaws, "water.relative_conductivity"),
  ];
};

export const writePressureSmoothing: Writer = () => [
  {
    text:
      "Pore pressures were smoothed by averaging what makes them rise, $\\Delta\\zeta_e=S\\Delta\\varepsilon_{vol}+" +
      "\\Delta t\\operatorname{div}[\\theta(\\mathbf w-\\mathbf v)]$, over the nodes and back. This moves water " +
      "between " +
      "neighbours and loses none:",
  },
  {
    tex: "m_w\\leftarrow m_w-\\rho_wV_p\\left(\\Delta\\bar\\zeta_e-\\Delta\\zeta_e\\right)",
    plain: "m_w ← m_w − ρ_w V_p (Δζ̄_e − Δζ_e)",
  },
];

const surfaceLaws: { [word: string]: string } = {
  total_head: "below a level the pressure of standing water acts on water and soil, and above it lies a seepage face",
  pressure: "the pore pressure is prescribed",
  seepage_face: "water may leave at zero pressure, and none enters",
  rain: "no more enters than rains, and what does not enter is counted as runoff",
  flux: "a given flow enters whatever the pressure",
  no_flow: "no water passes",
};

/** How a surface holds back what it may not let in, where the phases have velocities of their own. */
const limitingImpulse: Block[] = [
  {
    text:
      "Where the flow through the surface is limited to $\\hat q_n$, an impulse between the phases along the normal " +
      "$\\hat{\\mathbf n}$, which keeps the momentum of both, enforces",
  },
  {
    tex: "\\theta_i(\\mathbf w_i-\\mathbf v_i)\\cdot\\hat{\\mathbf n}\\ge\\hat q_n",
    plain: "θ_i (w_i − v_i) · n ≥ q_n (outflow is positive)",
  },
];

/** The same with pressures at the nodes. */
const constantPressure: Block[] = [
  {
    text:
      "Where water seeps, a node at which water stands or leaves has zero pressure, as long as no more enters there than " +
      "is offered; which nodes these are is found by solving again.",
  },
];

export const writeHydraulicConditions: Writer = ({ methods, result: { input } }) => {
  const used = findWords(input, "hydraulic", "condition").flatMap((word) => surfaceLaws[word] ?? []);
  return [
    {
      text:
        "Where the wet soil ends it meets hydraulic conditions, which go with the moving surface: a surface takes " +
        "the " +
        `condition of the nearest line.${used.length ? ` Here ${used.join("; ")}.` : ""} Surfaces without a ` +
        "condition are seepage faces.",
    },
    ...(methods.includes("seeping") && !methods.includes("two_phase") ? [] : limitingImpulse),
    ...(methods.includes("seeping") ? constantPressure : []),
    {
      text:
        "The water budget sums what passes the surface nodes, and agrees with the change of the water in the points " +
        "but for round-off.",
    },
  ];
};

export const writeSteadySeepage: Writer = () => [
  {
    text:
      "The pore pressures at the start are those of steady seepage, solved by linear finite elements on the same " +
      "mesh, " +
      "with the total head $H=y-p/\\gamma_w$:",
  },
  {
    tex: "\\operatorname{div}\\left(k\\,\\nabla H\\right)=0",
    plain: "div(k ∇H) = 0",
  },
  {
    text:
      "Newton's method finds heads, the state of every node of a seepage or rain face (water leaves at zero " +
      "pressure, or " +
      "none passes) and the water table together. Discharges are consistent nodal fluxes.",
  },
];

export const writeHeldPressures: Writer = ({ methods, result: { input } }) => {
  const where = quoteWhere(input, "water", "held");
  return [
    {
      text:
        `Pore pressures were held${where ? ` in ${where}` : ""}: a drained analysis at frozen geometry. The wet soil ` +
        "moves as one phase with the weight of grains and water, and the pressures act as constant forces,",
    },
    {
      tex:
        "m_i\\mathbf a_i=\\mathbf f_i^{\\,ext}-\\sum_pV_p" +
        "\\left(\\boldsymbol\\sigma'_p+\\chi_pp_p\\mathbf I\\right)\\nabla N_i",
      plain: "m_i a_i = f_i^ext − Σ_p V_p (σ′_p + χ_p p_p I) ∇N_i",
    },
    {
      text:
        "so that neither shearing nor settlement changes pressure or suction." +
        (methods.includes("frozen_factor") ? " A factor found so is a drained one." : ""),
    },
  ];
};
