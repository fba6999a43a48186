// SPDX-License-Identifier: MIT
/** Paragraphs on the models of soil, its water and roots; formulas as in the theory pages of the manual. */
import { findWords, quoteWhere } from "./settings";
import { prose, type MethodTexts } from "./writer";

const waldron = prose`
  Wu and Waldron [@wu1979; @waldron1977] let all roots that cross a shear plane break at once:
  $$c_r=k'\sum_i T_i\,a_i,\qquad k'=\cos\theta\,\tan\varphi+\sin\theta$$
  c_r = k′ Σ_i T_i a_i,  k′ = cos θ tan φ + sin θ $$`;

const fibres = prose`
  In a fibre bundle [@pollen2005] the load is shared equally by the roots that are left, and the root that bears least,
  $F_i=T_i\pi d_i^2/4$, breaks first; $n_i$ roots of a class cross a unit of area:
  $$c_r=k'\max_j\,F_j\sum_{i:\,F_i\ge F_j}n_i$$ c_r = k′ max_j F_j Σ_i n_i (over i with F_i ≥ F_j) $$`;

const retentionLaws: { [word: string]: string } = {
  van_genuchten: prose`
    Retention after van Genuchten [@vangenuchten1980], over the suction $s=p>0$:
    $$S=S_{min}+(S_{max}-S_{min})\left[1+\left(\frac s{p_{ref}}\right)^{\frac1{1-\lambda}}\right]^{-\lambda}$$
    S = S_min + (S_max − S_min) [1 + (s / p_ref)^(1 / (1 − λ))]^(−λ) $$`,
  linear: prose`
    Retention along a straight line from $S_{max}$ at no suction to $S_{min}$ at $s_{dry}$:
    $$S=\max\left(S_{min},\;S_{max}-(S_{max}-S_{min})\frac s{s_{dry}}\right)$$
    S = max(S_min, S_max − (S_max − S_min) s / s_dry) $$`,
  exponential: prose`
    Exponential retention after Gardner [@gardner1958]:
    $$S=S_{min}+(S_{max}-S_{min})\,e^{-\alpha s}$$ S = S_min + (S_max − S_min) exp(−α s) $$`,
  table: "A table of measured pairs of suction and saturation was joined by monotone cubics.",
  saturated: "Soil with the retention “saturated” stays saturated at any suction.",
};

const conductivityLaws: { [word: string]: string } = {
  constant: "A constant conductivity is that of the saturated soil at any suction.",
  mualem: prose`
    Conductivity after Mualem [@mualem1976], with $X$ the (or, where stated, the effective) saturation:
    $$k=k_s\sqrt X\left[1-\left(1-X^{1/\lambda}\right)^{\lambda}\right]^2$$ k = k_s √X [1 − (1 − X^(1/λ))^λ]² $$`,
  hillel: prose`
    Conductivity as a power of the saturation $X$ [@hillel1971]:
    $$k=k_s\,X^{\,r}$$ k = k_s X^r $$`,
  exponential: prose`
    Exponential conductivity after Gardner [@gardner1958]:
    $$k=k_s\,e^{-\alpha s}$$ k = k_s exp(−α s) $$`,
};

const surfaceLaws: { [word: string]: string } = {
  total_head: "below a level the pressure of standing water acts on water and soil, and above it lies a seepage face",
  pressure: "the pore pressure is prescribed",
  seepage_face: "water may leave at zero pressure, and none enters",
  rain: "no more enters than rains, and what does not enter is counted as runoff",
  flux: "a given flow enters whatever the pressure",
  no_flow: "no water passes",
  free_drainage: "water drains downwards by its weight alone, under a gradient of 1",
};

/** How a surface holds back what it may not let in, where the phases have velocities of their own. */
const limitingImpulse = prose`
  Where the flow through the surface is limited to $\hat q_n$, an impulse between the phases along the normal
  $\hat{\mathbf n}$, which keeps the momentum of both, enforces
  $$\theta_i(\mathbf w_i-\mathbf v_i)\cdot\hat{\mathbf n}\ge\hat q_n$$
  θ_i (w_i − v_i) · n ≥ q_n (outflow is positive) $$`;

/** The same with pressures at the nodes. */
const constantPressure = prose`
  Where water seeps, a node at which water stands or leaves has zero pressure, as long as no more enters there than is
  offered; which nodes these are is found by solving again.`;

export const soils = {
  mohr_coulomb: ["Mohr–Coulomb model", () => prose`
    The soil is linear elastic and perfectly plastic, with Mohr–Coulomb strength, plastic flow by the dilatancy angle,
    and a tension cut-off. With principal stresses $\sigma_1\ge\sigma_2\ge\sigma_3$, positive in tension, the yield
    function, the plastic potential and the cut-off are
    $$f=k\,\sigma_1-\sigma_3-2c\sqrt k,\quad k=\frac{1+\sin\,\varphi}{1-\sin\,\varphi};\qquad
    g=m\,\sigma_1-\sigma_3,\quad m=\frac{1+\sin\,\psi}{1-\sin\,\psi};\qquad f_t=\sigma_1-\sigma_t$$
    f = k σ_1 − σ_3 − 2 c √k,  k = (1 + sin φ)/(1 − sin φ);  g = m σ_1 − σ_3,  m = (1 + sin ψ)/(1 − sin ψ);  f_t = σ_1 −
    σ_t $$
    with cohesion $c$, friction angle $\varphi$, dilatancy angle $\psi$ and tensile strength $\sigma_t$, which is at
    most $c/\tan\,\varphi$. The elastic trial stress is returned in principal stresses to the plane, edge or apex that
    is active [@clausen2007]; the flow of the cut-off is associated.`],
  drucker_prager: ["Drucker–Prager model", () => prose`
    The soil is linear elastic and perfectly plastic with the cone of Drucker and Prager and a cut-off of the mean
    tension. With the mean stress $p$, positive in tension,
    $$f=\sqrt{J_2}+\eta\,p-\xi c,\quad g=\sqrt{J_2}+\eta_\psi\,p,\qquad f_t=p-\sigma_t$$
    f = √J_2 + η p − ξ c,  g = √J_2 + η_ψ p,  f_t = p − σ_t $$
    where $\eta$, $\xi$ and $\eta_\psi$ give the cone the strength and dilatancy of Mohr–Coulomb’s pyramid on the
    meridian, or in the plane strain, that the input names.`],
  softening: ["Softening", () => prose`
    In soil that softens, $c$ and $\tan\,\varphi$ fall linearly from their peak to their residual values with the
    deviatoric plastic strain $\varepsilon_q^p=\int\sqrt{\tfrac23\dot{\mathbf e}^p:\dot{\mathbf e}^p}\,dt$, and $\psi$
    falls to zero. The strength of a step is that of the strain at its start.`],
  bedding: ["Bedding planes", () => prose`
    On planes in the direction of the bedding $|\tau|\le c_b-\sigma_n'\tan\,\varphi_b$ holds besides the strength of the
    soil. The stress is returned to both surfaces in turn until neither is exceeded; sliding along the planes dilates
    by their own angle.`],
  root_cohesion: ["Cohesion of roots", ({ result: { input } }) => {
    const bundles = findWords(input, "roots", "bundle.model");
    return prose`
      Roots in Mohr–Coulomb soils add a cohesion $c_r$ to that of the soil. It belongs to the material points and is
      there from the first strain on.${bundles.length === 0 ? " Its value is given." : ""}

      ${bundles.includes("wu_waldron") ? waldron : ""}

      ${bundles.includes("fibre_bundle") ? fibres : ""}

      ${bundles.length > 0 ? "with tensile strength $T$, area ratio $a$ and diameter $d$ of each class of roots." : ""}`;
  }],
  modified_cam_clay: ["Modified Cam-clay", () => prose`
    Cam-clay soils follow modified Cam-clay with associated flow [@roscoe1968], which hardens with plastic volume and
    with suction [@tamagnini2004]. With mean effective stress $p'$ and volumetric strain positive in compression,
    deviatoric stress $q$ and degree of saturation $S$,
    $$f=\frac{q^2}{M^2}-p'\left(p'_c-p'\right),\qquad p'_c=p'_b\,e^{\,b(1-S)},\qquad \dot
    p'_b=\frac{1+e}{\lambda-\kappa}\,p'_b\,\dot\varepsilon_v^p$$
    f = q²/M² − p′ (p′_c − p′),  p′_c = p′_b exp(b (1 − S)),  dp′_b = (1 + e)/(λ − κ) p′_b dε_v^p $$
    $$K=\frac{1+e}{\kappa}\max\left(p',p'_{min}\right),\qquad G=\frac{3(1-2\nu)}{2(1+\nu)}\,K$$
    K = (1 + e)/κ · max(p′, p′_min),  G = 3 (1 − 2ν)/(2 (1 + ν)) K $$
    The void ratio $e$ follows the volumetric strain. The stress is returned implicitly to the yield surface
    [@borja1990] at the suction and void ratio of the end of the step.`],
  rooted_cam_clay: ["Rooted Cam-clay", () => prose`
    In rooted Cam-clay soils soil and roots are one material after Świtała and others [@switala2018], with the slope of
    the critical state raised as in the source [@source], whose chapter 4 the model follows:
    $$M_r=M_0+R_a m_r,\qquad p'_c=p'_b\,e^{\,b(1-S)+h},\qquad h_0=R_p m_r,\quad \dot h=R_p
    m_r\,e\,\dot\varepsilon_r,\quad \dot\varepsilon_r=\dot\varepsilon_v+\dot\varepsilon_q$$
    M_r = M_0 + R_a m_r,  p′_c = p′_b exp(b (1 − S) + h),  h_0 = R_p m_r,  dh = R_p m_r e dε_r,  dε_r = dε_v + dε_q $$
    The root content $m_r$ is the dry mass of roots over that of the soil, in per cent everywhere. Where a breaking
    strain is given, $R_a m_r$ and $h$ are multiplied by the share of the roots that is not broken.`],
  external_model: ["External model", ({ result: { input } }) => {
    const libraries = findWords(input, "materials", "library");
    return prose`
      Stress follows strain as a compiled UMAT says${libraries.length > 0 ? ` (${libraries.join(", ")})` : ""}: it is
      called for each material point and step with stress, strain increment, state variables and constants, and returns
      the new stress.`;
  }],
  linear_elastic: ["Linear elastic model", () => prose`
    Where the materials are linear elastic, the stress follows Hooke’s law and has no limit:
    $$\Delta\boldsymbol\sigma=\lambda\,\operatorname{tr}(\Delta\boldsymbol\varepsilon)\,\mathbf
    I+2\mu\,\Delta\boldsymbol\varepsilon,\quad \lambda=\frac{E\nu}{(1+\nu)(1-2\nu)},\quad \mu=\frac{E}{2(1+\nu)}$$
    Δσ = λ tr(Δε) I + 2 μ Δε,  λ = E ν / ((1 + ν)(1 − 2ν)),  μ = E / (2 (1 + ν)) $$`],
  soil_water: ["Effective stress, retention and conductivity", ({ result: { input } }) => {
    const pick = (laws: { [word: string]: string }, key: string) =>
      findWords(input, "materials", key).flatMap((word) => laws[word] ?? []).join("\n\n");
    const khalili = findWords(input, "materials", "water.chi").includes("khalili_khabbaz");
    return prose`
      Strength and stiffness follow the effective stress of Bishop [@bishop1959],
      $\boldsymbol\sigma'=\boldsymbol\sigma-\chi p\,\mathbf I$ in the signs used here, with
      $\chi=S$${
        khalili
          ? ", or after Khalili and Khabbaz [@khalili1998] with $\\chi=(s/s_e)^{-0.55}$ above the air entry $s_e$ and 1 " +
            "below it."
          : "."
      }

      ${pick(retentionLaws, "water.retention")}

      ${pick(conductivityLaws, "water.relative_conductivity")}`;
  }],
  steady_seepage: ["Steady seepage at the start", () => prose`
    The pore pressures at the start are those of steady seepage, solved by linear finite elements on the same mesh, with
    the total head $H=y-p/\gamma_w$:
    $$\operatorname{div}\left(k\,\nabla H\right)=0$$ div(k ∇H) = 0 $$
    Newton's method finds heads, the state of every node of a seepage or rain face (water leaves at zero pressure, or
    none passes) and the water table together. Discharges are consistent nodal fluxes.`],
  hydraulic_conditions: ["Hydraulic conditions", ({ methods, result: { input } }) => {
    const used = findWords(input, "hydraulic", "condition").flatMap((word) => surfaceLaws[word] ?? []);
    return prose`
      Where the wet soil ends it meets hydraulic conditions, which go with the moving surface: a surface takes the
      condition of the nearest line.${used.length ? ` Here ${used.join("; ")}.` : ""} Surfaces without a condition are
      seepage faces.

      ${methods.includes("seeping") && !methods.includes("two_phase") ? "" : limitingImpulse}

      ${methods.includes("seeping") ? constantPressure : ""}

      The water budget sums what passes the surface nodes, and agrees with the change of the water in the points but for
      round-off.`;
  }],
  held_pressures: ["Held pore pressures", ({ methods, result: { input } }) => {
    const where = quoteWhere(input, "water", "held");
    return prose`
      Pore pressures were held${where ? ` in ${where}` : ""}: a drained analysis at frozen geometry. The wet soil moves
      as one phase with the weight of grains and water, and the pressures act as constant forces,
      $$m_i\mathbf a_i=\mathbf f_i^{\,ext}-\sum_pV_p\left(\boldsymbol\sigma'_p+\chi_pp_p\mathbf I\right)\nabla N_i$$
      m_i a_i = f_i^ext − Σ_p V_p (σ′_p + χ_p p_p I) ∇N_i $$
      so that neither shearing nor settlement changes pressure or
      suction.${methods.includes("frozen_factor") ? " A factor found so is a drained one." : ""}`;
  }],
} satisfies MethodTexts;
