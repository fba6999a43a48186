// SPDX-License-Identifier: MIT
#pragma once
// The list of constitutive laws and the soils of a case, without the equations of the laws (law.hpp). A new law needs
// its header, a word in `Law`, and its new blocks in `SoilNumbers`; all other code reads its traits.

#include <optional>
#include <string>
#include <type_traits>
#include <variant>

#include "material/inputs.hpp"

namespace talus::material {

class MohrCoulomb;
class RootedMohrCoulomb;
class SofteningMohrCoulomb;
class DruckerPrager;
class Tresca;
class Shansep;
struct Adp;
struct Anisotropic;
class Bedding;
struct PowerCurve;
struct StrengthTable;
struct HoekBrown;
class SofteningHoekBrown;
struct BartonBandis;
template <bool Rooted>
class CamClay;
using ModifiedCamClay = CamClay<false>;
using RootedCamClay = CamClay<true>;
struct LinearElastic;
struct NoStrength;
class External;

using Law = std::variant<MohrCoulomb, RootedMohrCoulomb, SofteningMohrCoulomb, DruckerPrager, Tresca, Shansep, Adp,
                         Anisotropic, Bedding, PowerCurve, StrengthTable, HoekBrown, SofteningHoekBrown, BartonBandis,
                         ModifiedCamClay, RootedCamClay, LinearElastic, NoStrength, External>;

/// Union of the blocks of all laws, in the order of their first use.
using SoilNumbers =
    Numbers<YoungInput, PoissonInput, MohrCoulombStrength, CohesionGradient, RootCohesionInput, ResidualStrength,
            SofteningRange, DruckerPragerInput, TrescaInput, StrengthProfile, ShansepInput, AdpInput, AnisotropicInput,
            BeddingInput, PowerCurveInput, FlowRatio, StrengthTableInput, HoekBrownInput, ResidualIndex, JointInput,
            CamClayInput, Preconsolidation, RootParameters, ExternalParameters>;

/// Position of a type in a list of types, -1 for others.
template <class Wanted, class List>
struct PlaceOf;
template <class Wanted, template <class...> class List, class... L>
struct PlaceOf<Wanted, List<L...>> {
  static constexpr int value = [] {
    int place = 0;
    const bool found = ((std::is_same_v<L, Wanted> || (++place, false)) || ...);
    return found ? place : -1;
  }();
};
template <class L>
inline constexpr Model model_of = Model(PlaceOf<L, Law>::value);

/// Number of laws.
inline constexpr int model_count = static_cast<int>(std::variant_size_v<Law>);
const Traits& get_traits(Model model);

/// Returns true if the law of `model` needs a block of input.
bool needs_block(Model model, int place);
template <class Block>
bool needs(Model model) {
  return needs_block(model, PlaceOf<Block, SoilNumbers>::value);
}

/// Lists the words of the models that satisfy `holds`, in quotation marks: '"a", "b" or "c"'.
std::string list_words(bool (*holds)(const Traits&), const char* last = " or ");
/// Lists the models that LEM, FEM and partial factors accept.
std::string list_sliceable();

// Functions of the soil of a case.

/// Returns the law of a soil with changed strength. Throws Error (wrong_input) if an external model is to be reduced,
/// or if its library cannot be opened.
Law make_law(Model model, const SoilNumbers& in, const StrengthChange& change);
void check_soil(Model model, const SoilNumbers& in, const SoilFindings& findings);
Properties list_properties(Model model, const SoilNumbers& in);
/// Lists the properties that follow from the roots, of which the soil has at most `content` [%].
Properties list_root_properties(Model model, const SoilNumbers& in, double content);
/// Returns the name of the soil's model in reports.
std::string describe_model(Model model, const SoilNumbers& in);
/// Returns the strength for LEM; std::nullopt for a law without cohesion and friction angle.
std::optional<SliceStrength> find_slice_strength(Model model, const SoilNumbers& in);
void divide_strength(Model model, SoilNumbers& in, PartialDivision& division);
/// Returns true if divide_strength() changes soils of this model.
bool is_divisible(Model model);
/// Returns true if the law is in total stresses, so that pore pressure does not act.
bool is_total_stress(Model model, const SoilNumbers& in);
/// Returns the model of the same soil with the cohesion as a state variable, where the cohesion varies in space.
std::optional<Model> find_local_model(Model model, const SoilNumbers& in);
/// Returns E_c of a soil with constant stiffness [Pa].
std::optional<double> find_oedometric_modulus(Model model, const SoilNumbers& in);
/// Replaces a soil that softens by the one of limit states, without softening. Others are unchanged.
void stop_softening(Model& model, SoilNumbers& in);
}  // namespace talus::material
