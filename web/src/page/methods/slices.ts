// SPDX-License-Identifier: MIT
/** Paragraphs on limit equilibrium: the methods of slices, the search, rapid drawdown, the yield acceleration. */
import { listRestrictions } from "../../slices/restrictions";
import { findSetting, quoteNumber } from "./settings";
import { prose, type MethodTexts } from "./writer";

const stages =
  "Rapid drawdown in stages [@duncan1990; @usace2003]. The slope before drawdown gives, on each base, the effective " +
  "normal stress $\\sigma'_{fc}=N'/l$ and the shear stress $\\tau_{fc}=T/l$ under which its soil was consolidated. After " +
  "drawdown soil with an undrained envelope ($c_R$, $\\varphi_R$) has an undrained strength from these, ";
const third =
  ". Bases whose drained strength is lower, by the total normal stresses of this second stage and the pore pressures " +
  "after drawdown, take that in a third";
const others =
  "; other soils drain and have the pore pressures after drawdown. Every surface of the search went through all stages.";

const inclinations: { [name: string]: string } = {
  corps_1: "Corps of Engineers #1: parallel to the line between the ends of the surface",
  corps_2: "Corps of Engineers #2: parallel to the ground above them",
  lowe_karafiath: "Lowe and Karafiath: at the mean of the angles of ground and base",
  modified_swedish: "Modified Swedish: parallel to the face, from the lower end to the crest of the mass",
};

const searches: { [kind: string]: string } = {
  entry_exit: "circles through points of exit and entry on the ground, several depths each",
  grid: "circles about a grid of centres, several radii each",
  block: "polylines through windows or along a layer, with ranges of inclination of their ends",
};

export const slices = {
  limit_equilibrium: ["Methods of slices", ({ result }) => prose`
    The mass above a slip surface was cut into ${result.lem?.slices ?? "vertical"} slices, with sides at least at the
    breaks of the ground and where the surface passes into another soil. On the base of each slice, of length $l$ and
    inclination $\alpha$, the strength is mobilised by the same share,
    $$T=\frac1F\left(c\,l+(N-u\,l)\tan\,\varphi\right)$$ T = (c l + (N − u l) tan φ) / F $$
    with $N$ the total normal force, $u$ the pore pressure there (below the water table $\gamma_w$ times the depth under
    it, or of the seepage calculation), and $c$ with what roots and suction add [@duncan2014]. Ponded water and
    surcharges load the ground; water in a tension crack presses on its side. The methods differ in what they assume of
    the forces $E$ and $X$ between slices, and in the equilibrium that they satisfy.`],
  fellenius: ["Fellenius", () => prose`
    Fellenius (ordinary method) [@fellenius1936]: no forces between slices; moments only,
    $$F=\frac{\sum\left(c\,l+(W\cos\,\alpha-u\,l)\tan\,\varphi\right)}{\sum W\sin\,\alpha}$$
    F = Σ (c l + (W cos α − u l) tan φ) / Σ W sin α $$
    With high pore pressures on steep bases the method is too low; other authors take the pore pressure off the weight
    first and get another number. Here it is the classical form above.`],
  bishop: ["Bishop", () => prose`
    Bishop, simplified [@bishop1955]: horizontal forces between slices, vertical equilibrium and moments,
    $$F=\frac{\sum\left(c\,b+(W-u\,b)\tan\,\varphi\right)/m_\alpha}{\sum W\sin\,\alpha},\qquad
    m_\alpha=\cos\,\alpha+\frac{\sin\,\alpha\tan\,\varphi}F$$
    F = Σ (c b + (W − u b) tan φ) / m_α / Σ W sin α,  m_α = cos α + sin α tan φ / F $$
    for circles; $b$ is the width of a slice. Loads on the ground and earthquakes enter $W$ and the moments.`],
  janbu: ["Janbu", () => prose`
    Janbu, simplified [@janbu1973]: as Bishop, with equilibrium of horizontal forces in place of moments,
    $$F=f_0\,\frac{\sum\left(c\,b+(W-u\,b)\tan\,\varphi\right)/(m_\alpha\cos\,\alpha)}{\sum W\tan\,\alpha}$$
    F = f_0 Σ (c b + (W − u b) tan φ) / (m_α cos α) / Σ W tan α $$
    where $f_0$, by the depth of the surface over its length and the kind of soil, is 1 without correction.`],
  spencer: ["Spencer", () => prose`
    Spencer [@spencer1967]: the forces between slices are parallel, $X=\lambda E$ with one $\lambda$ for all; forces and
    moments of every slice are in balance. $F$ and $\lambda$ solve the two equations at the end of the last slice: no
    force and no moment is left over.`],
  morgenstern_price: ["Morgenstern–Price", ({ result }) => {
    const constant = result.lem?.methods.includes("morgenstern_price_constant");
    return prose`
      Morgenstern–Price [@morgenstern1965]: $X=\lambda f(x)E$, with $f$ half a sine wave along the
      slide${constant ? " (and constant, which are Spencer's forces)" : ""}; forces and moments of every slice are in
      balance, as with Spencer.`;
  }],
  force_equilibrium: ["Equilibrium of forces", ({ result }) => prose`
    The forces between slices have given inclinations, and $F$ closes the forces of the last slice; moments are not in
    balance. ${(result.lem?.methods ?? []).flatMap((method) => inclinations[method] ?? []).join(". ")}.`],
  slip_search: ["Search for the critical surface", ({ result }) => {
    const { input } = result;
    const search = result.lem?.search;
    const kind = searches[search?.kind ?? ""] ?? "trial surfaces";
    const polyline = (result.lem?.noncircular ?? []).length > 0;
    return prose`
      ${search ? search.tried.toLocaleString("en").replaceAll(",", "\u202f") : "Many"} surfaces were tried: ${kind}.
      From the best separate minima ${
        search?.kind === "block"
          ? "each surface was improved by a local search within its windows and ranges; other surfaces can be weaker."
          : "the circle was improved by a local search over its ends and its depth"
      }${
        search?.kind === "block"
          ? ""
          : polyline
          ? `, and from the critical circle a polyline of ${quoteNumber(input, "lem.vertices", "12")} vertices by ` +
            "moving them. A polyline can be weaker than every circle."
          : ". A surface that is no circle can be weaker."
      }${search?.restrictions ? ` ${listRestrictions(search.restrictions).join(" ")}` : ""}

      ${findSetting(input, "lem.reject") === false ? prose`
      Surfaces with doubtful forces were kept, and are named in the remarks.` : prose`
      A surface was refused where $m_\alpha$ falls below ${quoteNumber(input, "lem.smallest_m_alpha", "0.2")} ($N$ grows
      beyond bounds at a steep passive end), where effective normal forces are tensile over more than
      ${quoteNumber(input, "lem.most_tension", "0.2")} of the base, or where the line of thrust leaves the mass at more
      than ${quoteNumber(input, "lem.most_thrust_outside", "0.3")} of the sides of the slices; how many, and why, is
      counted.`}`;
  }],
  rapid_drawdown: ["Rapid drawdown", ({ result: { input } }) => {
    const method = findSetting(input, "lem.drawdown.method");
    if (method === "b_bar")
      return prose`
      Rapid drawdown in effective stresses [@bishop1954]: where water stood on the ground, pore pressures fall by $\bar
      B$ times the weight of the water that is gone, $u=u_0+\bar B\,\Delta\sigma_v$; soils without $\bar B$ drain and
      have the pore pressures after drawdown.`;
    if (method === "corps_1970")
      return prose`
      ${stages}the lower one of both envelopes,
      $$s=\min\left(c_R+\sigma'_{fc}\tan\,\varphi_R,\;c'+\sigma'_{fc}\tan\,\varphi'\right)$$
      s = min(c_R + σ'_fc tan φ_R, c' + σ'_fc tan φ') $$
      ${others.slice(2).replace(/^o/, "O")}`;
    return prose`
      ${stages}between those of isotropic consolidation and of consolidation at failure,
      $$s=\frac{(K_f-K_1)\,\tau_{K_c=1}+(K_1-1)\,\tau_{K_c=K_f}}{K_f-1},\qquad
      K_1=\frac{\sigma'_{fc}+\tau_{fc}(\sin\,\varphi'+1)/\cos\,\varphi'}{\sigma'_{fc}+\tau_{fc}(\sin\,\varphi'-1)/\cos\,\varphi'}$$
      s = ((K_f − K_1) τ(K_c = 1) + (K_1 − 1) τ(K_c = K_f)) / (K_f − 1),  K_1 = (σ'_fc + τ_fc (sin φ' + 1) / cos φ') /
      (σ'_fc + τ_fc (sin φ' − 1) / cos φ') $$
      with $K_f$ that of failure, and the lower of the two strengths where a principal stress would be a
      tension${method === "three_stage" ? third : ""}${others}`;
  }],
  yield_acceleration: ["Yield acceleration", () => prose`
    The yield acceleration $k_y$ is the horizontal acceleration over $g$, applied to every slice as a force $k_yW$ at
    its middle, with which the factor of safety of the surface is 1.`],
} satisfies MethodTexts;
