// SPDX-License-Identifier: MIT
#pragma once
// The input of a soil in blocks: a law names those that it needs, and laws share them. Each block is a plain struct
// with its keys, beside the law that brings it.

#include <limits>
#include <optional>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/lane.hpp"
#include "input/language/findings.hpp"
#include "input/language/spec.hpp"
#include "material/properties.hpp"

namespace talus::material {

// What a law may know of a point beside its stress and state.

/// What is known of the gaps of soil that comes apart (separation.hpp).
enum class Gaps {
  ignored,  ///< the soil keeps none: its volume grows as if it flowed
  none,     ///< none of these points has one yet; the state of gaps is not read
  kept,     ///< a gap closes before the soil bears load again
};

/// Softening over a length (theory 23), of laws whose traits soften.
template <class T>
struct Softening {
  T lent{0.0};  ///< plastic dilation of the neighbourhood beside the soil's own, which softens it [-]
  T softened{
      0.0};  ///< the law's answer: the soil's own of this step, in all directions, above zero where it dilates [-]
};

/// The rest of a point at the end of the step whose strain increment is given. Laws that need none of it ignore it.
template <class T>
struct Surroundings {
  T saturation{1.0};            ///< S_w of the pore water [-]; 1 in soil without pore water
  const int* points = nullptr;  ///< number of each lane's point, -1 where there is none; nullptr: not known
  double time = 0, dt = 0;      ///< start of the step and its length [s]
  Gaps gaps = Gaps::ignored;
  Softening<T>* softening = nullptr;  ///< of soil that softens over a length; nullptr: as its own point does
};

/// A quantity that a law has beside stress, for results.
struct StateField {
  std::string name;  ///< as stored, e.g. `void_ratio`
  std::string unit;  ///< SI
  /// What soil of laws without it shows: roots are absent from soil without roots; other quantities are no number
  /// there.
  double elsewhere = std::numeric_limits<double>::quiet_NaN();
};

/// The models whose law needs a block, and whether the material that is visited has one of them.
struct Users {
  std::vector<input::Alternative> models;

  /// A key that these models need, and one that they may have; with others it has no meaning.
  input::Spec need(input::Spec spec) const { return spec.condition = input::Condition{models, true}, spec; }
  input::Spec allow(input::Spec spec) const { return spec.condition = input::Condition{models, false}, spec; }
};

/// The blocks of a material that a law needs, as its functions receive them.
template <class... Block>
class Needs {
 public:
  /// Of all numbers of a material, or of what another law needs.
  template <class From>
  Needs(const From& from) : blocks_(pick<Block>(from)...) {}
  Needs(const Needs&) = default;

  template <class B>
  const B& get() const {
    return std::get<const B&>(blocks_);
  }
  template <class B>
  static constexpr bool has = (std::is_same_v<B, Block> || ...);

  /// The same blocks, to be changed.
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

/// All blocks of some laws, each once, in their order.
template <class... Block>
struct Numbers : Block... {
  template <class Work>
  void for_each_block(Work&& work) {
    (work(static_cast<Block&>(*this)), ...);
  }
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

/// How the strength of a stage or trial differs from that of the case.
struct StrengthChange {
  double factor = 1;               ///< divides the strength (3.14-3.15)
  std::optional<double> cohesion;  ///< in the place of the cohesion [Pa]
};

/// What the state of a point starts from.
struct StateStart {
  const double* stress;  ///< [Pa]
  double void_ratio = 0, saturation = 1;
  double root_content = 0;                                 ///< [%]
  double root_cohesion = 0;                                ///< [Pa]
  double level = std::numeric_limits<double>::infinity();  ///< vertical coordinate [m]
};

/// Where a check of one soil reports.
struct SoilFindings {
  const std::string& name;
  double porosity;
  bool gives_void_ratio;
  input::Findings& findings;

  std::string find_path(const std::string& key) const { return "materials." + name + (key.empty() ? "" : "." + key); }
  bool is_sound(const std::string& key) const { return findings.is_sound(find_path(key)); }
  bool is_given(const std::string& key) const { return findings.places.is_given(find_path(key)); }
  /// An empty key: of the material as a whole.
  void add(const std::string& key, const std::string& sentence) const { findings.add(find_path(key), sentence); }
};

}  // namespace talus::material
