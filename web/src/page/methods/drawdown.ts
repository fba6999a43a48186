// SPDX-License-Identifier: MIT
/** The paragraph on rapid drawdown in slices. */
import { findSetting } from "./settings";
import type { Writer } from "./writer";

const stages =
  "Rapid drawdown in stages [@duncan1990; @usace2003]. The slope before drawdown gives, on each base, the effective " +
  "normal stress $\\sigma'_{fc}=N'/l$ and the shear stress $\\tau_{fc}=T/l$ under which its soil was consolidated. After " +
  "drawdown soil with an undrained envelope ($c_R$, $\\varphi_R$) has an undrained strength from these, ";
const others =
  "; other soils drain and have the pore pressures after drawdown. Every surface of the search went through all stages.";

export const writeRapidDrawdown: Writer = ({ result: { input } }) => {
  const method = findSetting(input, "lem.drawdown.method");
  if (method === "b_bar")
    return [
      {
        text:
          "Rapid drawdown in effective stresses [@bishop1954]: where water stood on the ground, pore pressures fall by " +
          "$\\bar B$ times the weight of the water that is gone, $u=u_0+\\bar B\\,\\Delta\\sigma_v$; soils without " +
          "$\\bar B$ drain and have the pore pressures after drawdown.",
      },
    ];
  if (method === "corps_1970")
    return [
      { text: stages + "the lower one of both envelopes," },
      {
        tex:
          "s=\\min\\left(c_R+\\sigma'_{fc}\\tan\\,\\varphi_R,\\;c'+\\sigma'_{fc}\\tan\\,\\varphi'\\right)",
        plain: "s = min(c_R + σ'_fc tan φ_R, c' + σ'_fc tan φ')",
      },
      { text: others.slice(2).replace(/^o/, "O") },
    ];
  return [
    { text: stages + "between those of isotropic consolidation and of consolidation at failure," },
    {
      tex:
        "s=\\frac{(K_f-K_1)\\,\\tau_{K_c=1}+(K_1-1)\\,\\tau_{K_c=K_f}}{K_f-1},\\qquad " +
        "K_1=\\frac{\\sigma'_{fc}+\\tau_{fc}(\\sin\\,\\varphi'+1)/\\cos\\,\\varphi'}" +
        "{\\sigma'_{fc}+\\tau_{fc}(\\sin\\,\\varphi'-1)/\\cos\\,\\varphi'}",
      plain:
        "s = ((K_f − K_1) τ(K_c = 1) + (K_1 − 1) τ(K_c = K_f)) / (K_f − 1),  " +
        "K_1 = (σ'_fc + τ_fc (sin φ' + 1) / cos φ') / (σ'_fc + τ_fc (sin φ' − 1) / cos φ')",
    },
    {
      text:
        "with $K_f$ that of failure, and the lower of the two strengths where a principal stress would be a tension" +
        (method === "three_stage"
          ? ". Bases whose drained strength is lower, by the total normal stresses of this second stage and the pore " +
            "pressures after drawdown, take that in a third"
          : "") +
        others,
    },
  ];
};
