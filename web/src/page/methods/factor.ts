// SPDX-License-Identifier: MIT
/** Paragraphs on strength reduction, its criteria and the runout; rules as on the manual's page on the factor of safety. */
import { findSetting, quoteNumber } from "./settings";
import { prose, type MethodTexts } from "./writer";

export const factor = {
  strength_reduction: ["Strength reduction", () => prose`
    The factor of safety is the factor $F$ by which the shear strength of all soil has to be divided to bring the slope
    to failure [@matsui1992; @griffiths1999]:
    $$c_F=\frac cF,\qquad \varphi_F=\arctan\,\frac{\tan\,\varphi}F$$ c_F = c / F,  φ_F = arctan(tan φ / F) $$
    The dilatancy angle is kept, but never above the reduced friction angle; the tensile strength is divided by $F$ as
    well; stiffness is not changed. Trials start from the state at rest under the real strength. The factor depends on
    the dilatancy angle, which has to be quoted with it.`],
  frozen_factor: ["Rest or run-away at frozen geometry", ({ model, result: { input } }) => {
    const base = "strength_reduction.frozen";
    const force = quoteNumber(input, `${base}.rest.force_ratio`, "$10^{-3}$");
    const speed = quoteNumber(input, `${base}.rest.speed_ratio`, "$10^{-4}$");
    const hold = quoteNumber(input, `${base}.rest.hold`, "0.5");
    const failed = quoteNumber(input, `${base}.failed_displacement`, "0.1");
    const window = quoteNumber(input, `${base}.window`, "60");
    const meshes = findSetting(input, `${base}.meshes`);
    const ready = findSetting(input, "mesh.file");
    const extrapolated = meshes !== 1 && !ready;
    const finer = findSetting(input, `${base}.corner_refinement`);
    const corners =
      ready || finer === 1 ? "" : "finer at corners of the ground that point into the soil, such as the toe";
    const inSpace = model.dimension === 3; // tetrahedra converge more slowly
    const scattered = meshes !== 3 && findSetting(input, `${base}.mesh_scatter`) !== false;
    return prose`
      The factor of safety was found by rest or run-away at frozen geometry, that is, at small strains: positions and
      volumes of the points are kept, and a trial either comes to rest or runs away. It is at rest when the ratio of
      unbalanced to external force and the largest nodal speed are small,
      $$\frac{\lVert\mathbf f^{\,ext}-\mathbf f^{\,int}\rVert}{\lVert\mathbf f^{\,ext}\rVert}<r_f,\qquad
      \max_i\,|\mathbf v_i|<r_v\sqrt{gH}$$
      ‖f_ext − f_int‖ / ‖f_ext‖ < r_f,  max_i |v_i| < r_v √(g H) $$
      with $r_f$ = ${force} and $r_v$ = ${speed}, held for ${hold} s; it has failed when the largest displacement
      exceeds ${failed} $H$. A trial that does neither within ${window} s counts as failed. The interval between the
      largest factor at rest and the smallest that failed is narrowed until it is below the resolution asked for.

      ${extrapolated ? prose`
      The search was done on three meshes, of element size
      ${meshes === 3 ? "$h$, $h/2$ and $h/4$; the coarsest is $2h$ below" : "$2h$, $h$ and $h/2$"}${corners && `, ${corners}`}. The factor is where the straight line through them, by least squares with weights $1/h$, is at $h=0$:
      $$F=\tfrac1{13}\left(16\,F_{h/2}+2\,F_h-5\,F_{2h}\right)$$ F = (16 F_h/2 + 2 F_h − 5 F_2h) / 13 $$
      The bracket given with the factor is the width of the last intervals, carried through the extrapolation. What the
      mesh does is added: the largest of ${inSpace ? "one and a half times " : ""}the distance of the two finest
      factors, what the extrapolation takes from the
      finest${scattered ? ", the distance of the factors of two meshers at the size $h$," : ""} and 1 %.` : prose`
      The search was done on one mesh and not extrapolated;
      ${inSpace ? "on a vertical cut a single mesh of tetrahedra was 7 %" : "on eight slopes a single mesh was up to 5 %"}
      above the limit with elements of a thirteenth of the height, and ${inSpace ? "4.5 %" : "up to 2.5 %"} with half of
      that.${corners ? ` Its elements are ${corners}.` : ""}`}`;
  }],
  displacement_curve: ["Criteria on the displacement curve", ({ result: { input } }) => {
    const ratio = quoteNumber(input, "strength_reduction.curve.displacement_ratio", "0.03");
    const window = quoteNumber(input, "strength_reduction.curve.window", "5");
    const smoothing = findSetting(input, "strength_reduction.curve.smoothing");
    const locked =
      smoothing === "none"
        ? " The trials were calculated without smoothing; linear elements then lock, and every criterion on the curve is " +
          "too high, by 10 % or more on the dry slope of the source. They serve for comparison with published curves."
        : "";
    return prose`
      The curve of displacement over strength reduction factor was computed on moving geometry [@source]: each trial
      runs for ${window} s with its reduced strength, and its largest displacement $u$ is noted. The bilinear criterion
      [@feng2021] fits one straight line to the slowly rising and one to the steep branch; the factor is where they
      meet:
      $$u_1=a_1+b_1F,\quad u_2=a_2+b_2F\quad\Rightarrow\quad F=\frac{a_1-a_2}{b_2-b_1}$$
      u_1 = a_1 + b_1 F,  u_2 = a_2 + b_2 F  ⇒  F = (a_1 − a_2) / (b_2 − b_1) $$
      The displacement criterion takes the factor at which $u$ reaches ${ratio} $H$, with $H$ the height of the slope;
      the jump criterion takes the interval in which $\ln\,u$ grows fastest.${locked}`;
  }],
  runout: ["Runout", () => prose`
    The runout was computed on moving geometry, and compares the soil at the end with the state from which displacements
    are counted. Soil counts as moved where its displacement exceeds 1 % of $H$, the height of the slope. Its deposit is
    what began behind the toe and lies over the old ground. With $t(s)$ the mean thickness of the deposit over an element
    of size $h$, the front is the farthest place $s$ along the direction of motion where it is thick enough:
    $$s_f=\max\{s:t(s)\ge\max(H/20,\,h/4)\},\qquad V=\sum_{p\,:\,|\mathbf u_p|>0.01H}V_p$$
    s_f = largest s with t(s) ≥ max(H/20, h/4),  V = Σ V_p over points with |u_p| > 0.01 H $$
    The retreat of the crest is how far behind the crest the ground sank by as much. A measure whose uncertainty from two
    meshes exceeds half of it, and an element, is not determined. The results say whether the soil had come to rest when
    the calculation ended.`],
} satisfies MethodTexts;
