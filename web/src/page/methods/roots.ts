// SPDX-License-Identifier: MIT
/** Paragraphs on Cam-clay, bare and rooted, on the cohesion of roots and on external models; as in the theory pages. */
import { findWords } from "./settings";
import type { Block, Writer } from "./writer";

export const writeModifiedCamClay: Writer = () => [
  {
    text:
      "Cam-clay soils follow modified Cam-clay with associated flow [@roscoe1968], which hardens with plastic " +
      "volume and with suction [@tamagnini2004]. With mean effective stress $p'$ and volumetric strain positive in " +
      "compression, deviatoric stress $q$ and degree of saturation $S$,",
  },
  {
    tex:
      "f=\\frac{q^2}{M^2}-p'\\left(p'_c-p'\\right),\\qquad p'_c=p'_b\\,e^{\\,b(1-S)},\\qquad " +
      "\\dot p'_b=\\frac{1+e}{\\lambda-\\kappa}\\,p'_b\\,\\dot\\varepsilon_v^p",
    plain: "f = q²/M² − p′ (p′_c − p′),  p′_c = p′_b exp(b (1 − S)),  dp′_b = (1 + e)/(λ − κ) p′_b dε_v^p",
  },
  {
    tex: "K=\\frac{1+e}{\\kappa}\\max\\left(p',p'_{min}\\right),\\qquad G=\\frac{3(1-2\\nu)}{2(1+\\nu)}\\,K",
    plain: "K = (1 + e)/κ · max(p′, p′_min),  G = 3 (1 − 2ν)/(2 (1 + ν)) K",
  },
  {
    text:
      "The void ratio $e$ follows the volumetric strain. The stress is returned implicitly to the yield surface " +
      "[@borja1990] at the suction and void ratio of the end of the step.",
  },
];

export const writeRootedCamClay: Writer = () => [
  {
    text:
      "In rooted Cam-clay soils soil and roots are one material after Świtała and others [@switala2018], with the " +
      "slope of the critical state raised as in the source [@source], whose chapter 4 the model follows:",
  },
  {
    tex:
      "M_r=M_0+R_a m_r,\\qquad p'_c=p'_b\\,e^{\\,b(1-S)+h},\\qquad h_0=R_p m_r,\\quad " +
      "\\dot h=R_p m_r\\,e\\,\\dot\\varepsilon_r,\\quad \\dot\\varepsilon_r=\\dot\\varepsilon_v+\\dot\\varepsilon_q",
    plain:
      "M_r = M_0 + R_a m_r,  p′_c = p′_b exp(b (1 − S) + h),  h_0 = R_p m_r,  dh = R_p m_r e dε_r,  " +
      "dε_r = dε_v + dε_q",
  },
  {
    text:
      "The root content $m_r$ is the dry mass of roots over that of the soil, in per cent everywhere. Where a " +
      "breaking strain is given, $R_a m_r$ and $h$ are multiplied by the share of the roots that is not broken.",
  },
];

const waldron: Block[] = [
  { text: "Wu and Waldron [@wu1979; @waldron1977] let all roots that cross a shear plane break at once:" },
  {
    tex: "c_r=k'\\sum_i T_i\\,a_i,\\qquad k'=\\cos\\theta\\,\\tan\\varphi+\\sin\\theta",
    plain: "c_r = k′ Σ_i T_i a_i,  k′ = cos θ tan φ + sin θ",
  },
];

const fibres: Block[] = [
  {
    text:
      "In a fibre bundle [@pollen2005] the load is shared equally by the roots that are left, and the root that " +
      "bears least, $F_i=T_i\\pi d_i^2/4$, breaks first; $n_i$ roots of a class cross a unit of area:",
  },
  {
    tex: "c_r=k'\\max_j\\,F_j\\sum_{i:\\,F_i\\ge F_j}n_i",
    plain: "c_r = k′ max_j F_j Σ_i n_i (over i with F_i ≥ F_j)",
  },
];

export const writeRootCohesion: Writer = ({ result: { input } }) => {
  const bundles = findWords(input, "roots", "bundle.model");
  return [
    {
      text:
        "Roots in Mohr–Coulomb soils add a cohesion $c_r$ to that of the soil. It belongs to the material points and " +
        "is there from the first strain on." +
        (bundles.length === 0 ? " Its value is given." : ""),
    },
    ...(bundles.includes("wu_waldron") ? waldron : []),
    ...(bundles.includes("fibre_bundle") ? fibres : []),
    ...(bundles.length > 0
      ? [{ text: "with tensile strength $T$, area ratio $a$ and diameter $d$ of each class of roots." }]
      : []),
  ];
};

export const writeExternalModel: Writer = ({ result: { input } }) => {
  const libraries = findWords(input, "materials", "library");
  return [
    {
      text:
        `Stress follows strain as a compiled UMAT says${libraries.length > 0 ? ` (${libraries.join(", ")})` : ""}: ` +
        "it is called for each material point and step with stress, strain increment, state variables and " +
        "constants, and returns the new stress.",
    },
  ];
};
