// SPDX-License-Identifier: MIT
/** Paragraphs on limit equilibrium: the methods of slices, the search, the yield acceleration, partial factors. */
import { findSetting, quoteNumber } from "./settings";
import type { Writer } from "./writer";

export const writeLimitEquilibrium: Writer = ({ result }) => [
  {
    text:
      `The mass above a slip surface was cut into ${result.lem?.slices ?? "vertical"} slices, with sides at least at ` +
      "the breaks of the ground and where the surface passes into another soil. On the base of each slice, of length " +
      "$l$ and inclination $\\alpha$, the strength is mobilised by the same share,",
  },
  {
    tex: "T=\\frac1F\\left(c\\,l+(N-u\\,l)\\tan\\,\\varphi\\right)",
    plain: "T = (c l + (N − u l) tan φ) / F",
  },
  {
    text:
      "with $N$ the total normal force, $u$ the pore pressure there (below the water table $\\gamma_w$ times the depth " +
      "under it, or of the seepage calculation), and $c$ with what roots and suction add [@duncan2014]. Ponded water " +
      "and surcharges load the ground; water in a tension crack presses on its side. The methods differ in what they " +
      "assume of the forces $E$ and $X$ between slices, and in the equilibrium that they satisfy.",
  },
];

export const writeFellenius: Writer = () => [
  {
    text: "Fellenius (ordinary method) [@fellenius1936]: no forces between slices; moments only,",
  },
  {
    tex: "F=\\frac{\\sum\\left(c\\,l+(W\\cos\\,\\alpha-u\\,l)\\tan\\,\\varphi\\right)}{\\sum W\\sin\\,\\alpha}",
    plain: "F = Σ (c l + (W cos α − u l) tan φ) / Σ W sin α",
  },
  {
    text:
      "With high pore pressures on steep bases the method is too low; other authors take the pore pressure off the " +
      "weight first and get another number. Here it is the classical form above.",
  },
];

export const writeBishop: Writer = () => [
  {
    text: "Bishop, simplified [@bishop1955]: horizontal forces between slices, vertical equilibrium and moments,",
  },
  {
    tex:
      "F=\\frac{\\sum\\left(c\\,b+(W-u\\,b)\\tan\\,\\varphi\\right)/m_\\alpha}{\\sum W\\sin\\,\\alpha},\\qquad " +
      "m_\\alpha=\\cos\\,\\alpha+\\frac{\\sin\\,\\alpha\\tan\\,\\varphi}F",
    plain: "F = Σ (c b + (W − u b) tan φ) / m_α / Σ W sin α,  m_α = cos α + sin α tan φ / F",
  },
  { text: "for circles; $b$ is the width of a slice. Loads on the ground and earthquakes enter $W$ and the moments." },
];

export const writeJanbu: Writer = () => [
  {
    text: "Janbu, simplified [@janbu1973]: as Bishop, with equilibrium of horizontal forces in place of moments,",
  },
  {
    tex:
      "F=f_0\\,\\frac{\\sum\\left(c\\,b+(W-u\\,b)\\tan\\,\\varphi\\right)/(m_\\alpha\\cos\\,\\alpha)}" +
      "{\\sum W\\tan\\,\\alpha}",
    plain: "F = f_0 Σ (c b + (W − u b) tan φ) / (m_α cos α) / Σ W tan α",
  },
  { text: "where $f_0$, by the depth of the surface over its length and the kind of soil, is 1 without correction." },
];

const inclinations: { [name: string]: string } = {
  corps_1: "Corps of Engineers #1: parallel to the line between the ends of the surface",
  corps_2: "Corps of Engineers #2: parallel to the ground above them",
  lowe_karafiath: "Lowe and Karafiath: at the mean of the angles of ground and base",
  modified_swedish: "Modified Swedish: parallel to the face, from the lower end to the crest of the mass",
};

export const writeForceEquilibrium: Writer = ({ result }) => [
  {
    text:
      "The forces between slices have given inclinations, and $F$ closes the forces of the last slice; moments are not " +
      `in balance. ${(result.lem?.methods ?? []).flatMap((method) => inclinations[method] ?? []).join(". ")}.`,
  },
];

export const writeSpencer: Writer = () => [
  {
    text:
      "Spencer [@spencer1967]: the forces between slices are parallel, $X=\\lambda E$ with one $\\lambda$ for all; " +
      "forces and moments of every slice are in balance. $F$ and $\\lambda$ solve the two equations at the end of the " +
      "last slice: no force and no moment is left over.",
  },
];

export const writeMorgensternPrice: Writer = ({ result }) => {
  const constant = result.lem?.methods.includes("morgenstern_price_constant");
  return [
    {
      text:
        "Morgenstern–Price [@morgenstern1965]: $X=\\lambda f(x)E$, with $f$ half a sine wave along the slide" +
        (constant ? " (and constant, which are Spencer's forces)" : "") +
        "; forces and moments of every slice are in balance, as with Spencer.",
    },
  ];
};

const searches: { [kind: string]: string } = {
  entry_exit: "circles through points of exit and entry on the ground, several depths each",
  grid: "circles about a grid of centres, several radii each",
};

export const writeSlipSearch: Writer = ({ result }) => {
  const { input } = result;
  const search = result.lem?.search;
  const kind = searches[search?.kind ?? ""] ?? "trial surfaces";
  const polyline = (result.lem?.noncircular ?? []).length > 0;
  return [
    {
      text:
        `${search ? search.tried.toLocaleString("en").replaceAll(",", "\u202f") : "Many"} surfaces were tried: ${kind}. ` +
        "From the best separate minima the circle was improved by a local search over its ends and its depth" +
        (polyline
          ? `, and from the critical circle a polyline of ${quoteNumber(input, "lem.vertices", "12")} vertices by ` +
            "moving them. A polyline can be weaker than every circle."
          : ". A surface that is no circle can be weaker."),
    },
    ...(findSetting(input, "lem.reject") === false
      ? [{ text: "Surfaces with doubtful forces were kept, and are named in the remarks." }]
      : [
          {
            text:
              "A surface was refused where $m_\\alpha$ falls below " +
              `${quoteNumber(input, "lem.smallest_m_alpha", "0.2")} ($N$ grows beyond bounds at a steep passive end), ` +
              "where effective normal forces are tensile over more than " +
              `${quoteNumber(input, "lem.most_tension", "0.2")} of the base, or where the line of thrust leaves the mass ` +
              `at more than ${quoteNumber(input, "lem.most_thrust_outside", "0.3")} of the sides of the slices; how ` +
              "many, and why, is counted.",
          },
        ]),
  ];
};

export const writeYieldAcceleration: Writer = () => [
  {
    text:
      "The yield acceleration $k_y$ is the horizontal acceleration over $g$, applied to every slice as a force " +
      "$k_yW$ at its middle, with which the factor of safety of the surface is 1.",
  },
];

export const writePartialFactors: Writer = ({ result }) => [
  {
    text:
      `Strengths, weights and loads are design values${result.methods?.partial_factors?.set ? ` (${result.methods.partial_factors.set})` : ""} ` +
      "after Eurocode 7 [@en1997]: characteristic values with the partial factors of the table above. The factor " +
      "of safety that is found with them is the over-design factor; the slope is verified where it is 1 or more.",
  },
];
