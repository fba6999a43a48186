// SPDX-License-Identifier: MIT
#pragma once
// The list of constitutive laws. A soil is its header and one word here; everything else asks its traits.

#include <algorithm>
#include <array>
#include <variant>
#include <vector>

#include "material/cam_clay.hpp"
#include "material/external.hpp"
#include "material/linear_elastic.hpp"
#include "material/mohr_coulomb.hpp"
#include "material/rooted_mohr_coulomb.hpp"
#include "material/tresca.hpp"

namespace talus::material {

using Law =
    std::variant<MohrCoulomb, RootedMohrCoulomb, Tresca, ModifiedCamClay, RootedCamClay, LinearElastic, External>;

template <class Laws>
struct OfLaws;
template <class... L>
struct OfLaws<std::variant<L...>> {
  /// All numbers that a case may give of a soil.
  using Numbers = typename Joined<material::Numbers<>, typename L::Input...>::type;
  static constexpr std::array<Traits, sizeof...(L)> traits{L::traits...};
  static constexpr int max_state_size = std::max({L::state_size...});

  /// The model of a law.
  template <class Wanted>
  static constexpr Model find_model() {
    int place = 0;
    const bool found = ((std::is_same_v<L, Wanted> || (++place, false)) || ...);
    return Model(found ? place : -1);
  }
  /// The models whose law needs a block, `now` being that of the material.
  template <class Block>
  static Users list_users(Model now) {
    Users users;
    const auto add = [&]<class One>() {
      if constexpr (One::Input::template has<Block>)
        users.models.push_back({"model", '"' + std::string(One::traits.word) + '"', find_model<One>() == now});
    };
    (add.template operator()<L>(), ...);
    return users;
  }
  /// Calls work.template operator()<L>() for the law of a model.
  template <class Work>
  static void visit(Model model, Work&& work) {
    static_cast<void>(((find_model<L>() == model ? (work.template operator()<L>(), true) : false) || ...));
  }
};
using Laws = OfLaws<Law>;
using SoilNumbers = Laws::Numbers;

template <class L>
inline constexpr Model model_of = Laws::find_model<L>();
inline const Traits& get_traits(Model model) {
  return Laws::traits[static_cast<std::size_t>(model)];
}
/// Whether the law of `model` needs a block of input.
template <class Block>
bool needs(Model model) {
  bool answer = false;
  Laws::visit(model, [&]<class L>() { answer = L::Input::template has<Block>; });
  return answer;
}

/// The words of the models whose traits hold, in quotation marks: '"a", "b" or "c"'.
std::string list_words(bool (*holds)(const Traits&), const char* last = " or ");
/// Those that methods of slices, finite elements and partial factors take.
inline std::string list_sliceable() {
  return list_words([](const Traits& t) { return t.serves_slices && t.strength == Strength::known; });
}

/// Most state variables of any law. One of them is every plastic law's: the deviatoric plastic strain.
inline constexpr int max_state_size = Laws::max_state_size, common_state_size = 1;

inline int state_size(const Law& law) {
  return std::visit([](const auto& l) { return l.state_size; }, law);
}
inline const Traits& get_traits(const Law& law) {
  return Laws::traits[law.index()];
}

/// Laws that harden from a preconsolidation, which may be set after a stage of equilibrium.
template <class L>
concept IsPreconsolidated = requires(const L& l, const double* state) {
  l.find_preconsolidation(state, 1.0);
};

// Of the soil of a case.

/// The law of a soil, its strength changed. Throws Error (wrong_input) when an external model is to be reduced, or its
/// library cannot be opened.
Law make_law(Model model, const SoilNumbers& in, const StrengthChange& change);
void check_soil(Model model, const SoilNumbers& in, const SoilFindings& findings);
Properties list_properties(Model model, const SoilNumbers& in);
/// Those that follow from the roots, of which the soil has at most `content` [%].
Properties list_root_properties(Model model, const SoilNumbers& in, double content);
/// The name of the soil's model in reports.
std::string describe_model(Model model, const SoilNumbers& in);
/// Cohesion and friction angle; nothing of an elastic soil, nor of one that serves no slices.
std::optional<SliceStrength> find_slice_strength(Model model, const SoilNumbers& in);
void divide_strength(Model model, SoilNumbers& in, PartialDivision& division);
/// Whether stresses are total ones, on which pore water does not act.
bool is_total_stress(Model model, const SoilNumbers& in);
/// The model of the same soil whose cohesion is a state variable of its points, where it varies from place to place.
std::optional<Model> find_local_model(Model model, const SoilNumbers& in);
/// E_c of a soil whose stiffness does not change [Pa].
std::optional<double> find_oedometric_modulus(Model model, const SoilNumbers& in);
/// Fills what is found from the folder of the case.
template <class FindFile>
void complete_soil(SoilNumbers& in, const std::string& name, const FindFile& find_file) {
  [&]<class... L>(std::variant<L...>*) {
    const auto complete = [&]<class One>() {
      if constexpr (requires { One::complete(typename One::Input::Changeable(in), name, find_file); })
        One::complete(typename One::Input::Changeable(in), name, find_file);
    };
    (complete.template operator()<L>(), ...);
  }(static_cast<Law*>(nullptr));
}

// Of a point.

/// The state variables of a point at the start, of which `state` has room for max_state_size.
void set_initial_state(const Law& law, const SoilNumbers& in, const StateStart& start, double* state);
/// Takes the roots of a point out of its state, for another start.
void read_roots(const Law& law, const double* state, StateStart& start);
/// E_c of (2.84) of a point with stress `sigma` and state variables `state` [Pa].
double constrained_modulus(const Law& law, const double* sigma, const double* state);
/// Elastic energy density [J/m³].
template <int NS>
double elastic_energy(const Law& law, const double* sigma, const double* state);
/// What results show of a law beside stress and plastic strain, in the order of show_state().
std::vector<StateField> list_state_fields(const Law& law);
/// Writes one value per field. `saturation` is that of the pore water, 1 in dry soil.
void show_state(const Law& law, const double* state, double saturation, double* values);
/// The gap that the soil has come apart by, as a volume strain [-]; 0 for laws that keep none.
double find_gap(const Law& law, const double* state);
/// What a law could not calculate since the last look; the first point of it.
std::optional<LawFailure> take_failure(const Law& law);

}  // namespace talus::material
