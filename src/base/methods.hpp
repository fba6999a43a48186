// SPDX-License-Identifier: MIT
#pragma once
// The four methods of stability analysis, seepage alone, the methods of slices and those of rapid drawdown, with their
// words in case files and their titles.

#include <array>

namespace talus {

/// Limit equilibrium, finite elements, limit analysis, material point method; seepage alone, which yields no factor of
/// the slope.
enum class Method { lem, fem, bounds, mpm, seepage };

/// Returns the title of a method in reports.
constexpr const char* get_title(Method method) {
  constexpr std::array titles{"LEM", "FEM", "limit analysis", "MPM", "seepage"};
  return titles[static_cast<std::size_t>(method)];
}

enum class SliceMethod {
  fellenius,                   ///< ordinary method of slices; N' = W cosα - u l (classical form)
  bishop,                      ///< simplified; polylines: moments about the centre of a fitted circle, with a warning
  janbu,                       ///< simplified, f_0 = 1
  janbu_corrected,             ///< simplified, multiplied by f_0
  spencer,                     ///< parallel interslice forces
  morgenstern_price,           ///< half-sine interslice function
  morgenstern_price_constant,  ///< constant interslice function: Spencer's method in another formulation
  corps_1,          ///< force equilibrium; interslice forces parallel to the line between the ends of the surface
  corps_2,          ///< force equilibrium; interslice forces parallel to the ground above them
  lowe_karafiath,   ///< force equilibrium; inclination is the mean of ground and base
  modified_swedish  ///< force equilibrium; parallel to the face, from the lower end to the crest of the mass
};

/// A method of slices with its word in files and its title.
struct SliceMethodName {
  SliceMethod method;
  const char *word, *title;
};
inline constexpr std::array slice_methods{
    SliceMethodName{SliceMethod::fellenius, "fellenius", "Fellenius"},
    SliceMethodName{SliceMethod::bishop, "bishop", "Bishop simplified"},
    SliceMethodName{SliceMethod::janbu, "janbu", "Janbu simplified"},
    SliceMethodName{SliceMethod::janbu_corrected, "janbu_corrected", "Janbu corrected"},
    SliceMethodName{SliceMethod::spencer, "spencer", "Spencer"},
    SliceMethodName{SliceMethod::morgenstern_price, "morgenstern_price", "Morgenstern–Price"},
    SliceMethodName{SliceMethod::morgenstern_price_constant, "morgenstern_price_constant",
                    "Morgenstern–Price, constant function"},
    SliceMethodName{SliceMethod::corps_1, "corps_1", "Corps of Engineers #1"},
    SliceMethodName{SliceMethod::corps_2, "corps_2", "Corps of Engineers #2"},
    SliceMethodName{SliceMethod::lowe_karafiath, "lowe_karafiath", "Lowe–Karafiath"},
    SliceMethodName{SliceMethod::modified_swedish, "modified_swedish", "Modified Swedish"},
};

constexpr const char* to_word(SliceMethod method) {
  return slice_methods[static_cast<std::size_t>(method)].word;
}
constexpr const char* get_title(SliceMethod method) {
  return slice_methods[static_cast<std::size_t>(method)].title;
}

/// Method of rapid drawdown: the source of the strength after drawdown.
enum class DrawdownMethod {
  corps_1970,      ///< two stages; the lower of the R envelope and the effective envelope
  lowe_karafiath,  ///< two stages; interpolation between the envelopes by the principal stress ratio before drawdown
  three_stage,     ///< as lowe_karafiath, and the drained strength where it is lower (Duncan, Wright and Wong 1990)
  b_bar            ///< effective stress; pore pressure changes by B̄ times the removed water load
};

struct DrawdownMethodName {
  DrawdownMethod method;
  const char *word, *title;
};
inline constexpr std::array drawdown_methods{
    DrawdownMethodName{DrawdownMethod::corps_1970, "corps_1970", "two stages, Corps of Engineers 1970"},
    DrawdownMethodName{DrawdownMethod::lowe_karafiath, "lowe_karafiath", "two stages, Lowe and Karafiath"},
    DrawdownMethodName{DrawdownMethod::three_stage, "three_stage", "three stages, Duncan, Wright and Wong"},
    DrawdownMethodName{DrawdownMethod::b_bar, "b_bar", "pore pressures by B̄"},
};
constexpr const char* get_title(DrawdownMethod method) {
  return drawdown_methods[static_cast<std::size_t>(method)].title;
}

/// Returns how much of the equilibrium a method neglects: 0 none, 1 a part with minor effect on most slopes, 2 more.
/// The factor of a slope is taken from the methods of a run with the lowest rank.
constexpr int rank_equilibrium(SliceMethod method) {
  switch (method) {
    case SliceMethod::spencer:
    case SliceMethod::morgenstern_price:
    case SliceMethod::morgenstern_price_constant:
      return 0;
    case SliceMethod::bishop:
    case SliceMethod::janbu_corrected:
      return 1;
    default:
      return 2;
  }
}
/// Returns true if the method satisfies force and moment equilibrium.
constexpr bool is_rigorous(SliceMethod method) {
  return rank_equilibrium(method) == 0;
}

/// Returns true if the method satisfies force equilibrium only, with prescribed inclinations of interslice forces.
constexpr bool has_given_inclinations(SliceMethod method) {
  return method == SliceMethod::corps_1 || method == SliceMethod::corps_2 || method == SliceMethod::lowe_karafiath ||
         method == SliceMethod::modified_swedish;
}

/// Returns true if the method applies to non-circular surfaces.
constexpr bool suits_polylines(SliceMethod method) {
  return method != SliceMethod::fellenius && method != SliceMethod::bishop;
}

}  // namespace talus
