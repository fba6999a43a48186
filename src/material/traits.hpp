// SPDX-License-Identifier: MIT
#pragma once
// What the house asks of a soil beside its equations. Each law answers in its header, as `L::traits`.

#include <array>

namespace talus::material {

/// The constitutive model of a material: the place of its law in `Law` (law.hpp).
enum class Model : int;

enum class Strength {
  none,   ///< elastic
  known,  ///< it can be divided by a factor
  hidden  ///< the law has one, but not as numbers that a factor could divide
};

/// What roots bring to the points of a soil, from [[roots]] or from the material itself.
enum class RootEffect { none, content, cohesion };

struct Traits {
  const char* word;     ///< `model` in the case file
  const char* meaning;  ///< in the manual
  const char* title;    ///< in reports
  Strength strength = Strength::known;
  bool serves_slices =
      false;  ///< has a cohesion and a friction angle: slices, finite elements and partial factors take it
  bool has_friction = false;       ///< has cohesion, friction, dilatancy and tensile strength of Mohr and Coulomb
  bool takes_water = true;         ///< false: its stresses are total ones
  bool changes_stiffness = false;  ///< with stress and state, so that the critical step must be looked at often
  bool stores_always = false;      ///< its state changes in elastic steps too
  bool softens = false;            ///< with its plastic volume: over mesh.softening_length
  bool is_opaque = false;          ///< its inside is not known: tangents are differences
  RootEffect roots = RootEffect::none;
  /// Laws of one family keep this many state variables where one follows the other.
  const char* family = "";
  int family_states = 1;
  /// Paragraphs of the report's methods that explain it.
  std::array<const char*, 2> paragraphs{};
  /// A sentence of the report's assumptions, {} being the materials; and what a reduction divides.
  const char* assumption = nullptr;
  const char* reduction = nullptr;
};

}  // namespace talus::material
