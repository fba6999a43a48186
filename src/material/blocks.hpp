// SPDX-License-Identifier: MIT
#pragma once
// The input of constitutive laws in blocks: each law lists the blocks that it needs, and laws share blocks. A block is
// a plain struct with its keys, defined beside the law that introduces it.

#include <limits>
#include <optional>
#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

#include "base/shown_units.hpp"
#include "input/language/findings.hpp"
#include "input/language/spec.hpp"
#include "material/properties.hpp"

namespace talus::material {

// Quantities of a point that a law receives beside stress and state.

/// State of the gaps of separating soil (linear_elastic.hpp).
enum class Gaps {
  ignored,  ///< gaps are not tracked: volume grows as in plastic flow
  none,     ///< no point has a gap yet; the state of gaps is not read
  kept,     ///< a gap must close before compressive stress returns
};

/// Nonlocal softening (theory 23), for laws with Traits::softens.
template <class T>
struct Softening {
  T nonlocal_correction{0.0};  ///< nonlocal plastic dilation minus the local one, which softens the point [-]
  T softened{0.0};  ///< output: local plastic dilation of the step, in all directions, positive in dilation [-]
};

/// Further arguments of the update: the state at the end of the step of the strain increment. Laws ignore what they do
/// not need.
template <class T>
struct Surroundings {
  T saturation{1.0};            ///< S_w of the pore water [-]; 1 in soil without pore water
  const int* points = nullptr;  ///< point number of each lane, -1 for an empty lane; nullptr: unknown
  double time = 0, dt = 0;      ///< start and length of the step [s]
  Gaps gaps = Gaps::ignored;
  Softening<T>* softening = nullptr;  ///< nonlocal softening; nullptr: local softening
};

/// A state variable of a law in the results.
struct StateField {
  std::string name;  ///< name in results files, e.g. `void_ratio`
  std::string unit;  ///< SI
  /// Value in soils whose law lacks it: 0 where absence means zero, as for roots; NaN for other quantities.
  double elsewhere = std::numeric_limits<double>::quiet_NaN();
};

/// The models whose law needs a block; its functions make keys conditional on them.
struct Users {
  std::vector<input::Alternative> models;

  /// need() makes a key required with these models, allow() optional; with other models the key is rejected.
  input::Spec need(input::Spec spec) const { return spec.condition = input::Condition{models, true}, spec; }
  input::Spec allow(input::Spec spec) const { return spec.condition = input::Condition{models, false}, spec; }
};

/// References to the blocks of a material that a law needs; the argument of its functions.
template <class... Block>
class Needs {
 public:
  /// `from` holds all blocks of a material, or those of another law.
  template <class From>
  Needs(const From& from) : blocks_(pick<Block>(from)...) {}
  Needs(const Needs&) = default;

  template <class B>
  const B& get() const {
    return std::get<const B&>(blocks_);
  }
  template <class B>
  static constexpr bool has = (std::is_same_v<B, Block> || ...);

  /// The same blocks, writable.
  class Changeable {
   public:
    template <class From>
    explicit Changeable(From& from) : blocks_(pick_changeable<Block>(from)...) {}
    template <class B>
    B& get() const {
      return std::get<B&>(blocks_);
    }

   private:
    template <class B, class From>
    static B& pick_changeable(From& from) {
      if constexpr (std::is_base_of_v<B, std::remove_const_t<From>>)
        return from;
      else
        return from.template get<B>();
    }
    std::tuple<Block&...> blocks_;
  };

 private:
  template <class B, class From>
  static const B& pick(const From& from) {
    if constexpr (std::is_base_of_v<B, From>)
      return from;
    else
      return from.template get<B>();
  }

  std::tuple<const Block&...> blocks_;
};

/// All blocks of a list of laws, each once, in the order of first use.
template <class... Block>
struct Numbers : Block... {
  void for_each_block(auto&& work) { (work(static_cast<Block&>(*this)), ...); }
};

template <class Found, class... More>
struct Joined {
  using type = Found;
};
template <class... Found, class... More>
struct Joined<Numbers<Found...>, Needs<>, More...> : Joined<Numbers<Found...>, More...> {};
template <class... Found, class First, class... Block, class... More>
struct Joined<Numbers<Found...>, Needs<First, Block...>, More...>
    : Joined<std::conditional_t<(std::is_same_v<First, Found> || ...), Numbers<Found...>, Numbers<Found..., First>>,
             Needs<Block...>, More...> {};

/// Change of the strength in a stage or trial relative to the case.
struct StrengthChange {
  double factor = 1;               ///< divides the strength (3.14-3.15)
  std::optional<double> cohesion;  ///< replaces the cohesion [Pa]
};

/// Initial conditions from which the state of a point is set.
struct StateStart {
  const double* stress;  ///< [Pa]
  double void_ratio = 0, saturation = 1;
  double root_content = 0;                                 ///< [%]
  double root_cohesion = 0;                                ///< [Pa]
  double level = std::numeric_limits<double>::infinity();  ///< vertical coordinate [m]
  double x = 0;                                            ///< horizontal coordinate [m]
  double depth = 0;                                        ///< under the ground [m]
  double vertical = 0;                                     ///< σ'_v of the weight and the loads above [Pa]
  std::optional<double> strength_growth = std::nullopt;    ///< of an earlier state, instead of that of the place [Pa]
};

/// Findings of the check of one soil.
struct SoilFindings {
  const std::string& name;
  double porosity;
  bool gives_void_ratio;
  input::Findings& findings;
  const ShownUnits& units;  ///< units of messages

  std::string find_path(const std::string& key) const { return "materials." + name + (key.empty() ? "" : "." + key); }
  bool is_sound(const std::string& key) const { return findings.is_sound(find_path(key)); }
  bool is_given(const std::string& key) const { return findings.places.is_given(find_path(key)); }
  /// Adds a finding; an empty key refers to the material as a whole.
  void add(const std::string& key, const std::string& sentence) const { findings.add(find_path(key), sentence); }
};

}  // namespace talus::material
