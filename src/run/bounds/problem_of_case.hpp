// SPDX-License-Identifier: MIT
#pragma once
// The problem of limit analysis of a case: mesh, strength, weight, pore pressures, loads and supports, and the check
// of its loads.

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/vec.hpp"
#include "bounds/find_bounds.hpp"
#include "input/case/case.hpp"
#include "site/seepage_results.hpp"
#include "site/site.hpp"

namespace talus::run {

class BarsOfCase;
class CaseEnclosure;
class CaseFields;

struct ProblemOfCase {
  bounds::Problem problem;
  /// The same for the upper bound where strengths or pore pressures are not linear in each triangle, or forces of bars
  /// between their nodes: its strengths and forces are nowhere below and its pressures nowhere above those of the case,
  /// and those of `problem` conversely.
  std::optional<bounds::Problem> stronger;
  std::shared_ptr<const CaseFields> fields;
  std::shared_ptr<const CaseEnclosure> enclosure;  ///< for refined meshes; null: all is linear in the first mesh
  std::shared_ptr<const BarsOfCase> bars;          ///< the same for the forces of bars
  site::WaterResult water;                         ///< origin of the pore pressures
  std::vector<std::string> notes;  ///< sentences on what limit analysis does not take from the case as it is
};

/// Supports of the section.
enum class Supports {
  as_given,   ///< those of [[boundary]]
  below_soil  ///< base and ends of the section fixed, the ground free: the assumption of LEM
};

/// Makes the first mesh, with strength, weight, pore pressures, loads and supports. Pore pressures of steady seepage
/// are computed on this mesh. Throws Error (wrong_input) for a boundary or a load that limit analysis does not support,
/// and what mesh::generate() and find_held_water() throw.
ProblemOfCase make_bounds_problem(const site::Site& site, Supports supports = Supports::as_given);

/// Returns the bounds of a case: the lower bound of `problem`, and the upper one of `stronger` where there is one, held
/// to the strengths and pore pressures of the case (hold_to_case()).
bounds::BoundsResult find_case_bounds(const ProblemOfCase& made, const bounds::BoundsOptions& options,
                                      const bounds::BoundsReport& report = {});

/// Throws Error (wrong_input) if the size of [bounds] gives more triangles than its limit.
void check_bounds(const input::Case& data);

// The loads of limit analysis are compared with those of the case, since a certificate of another problem proves
// nothing.

/// A side of the ground, and its traction by surcharges and standing water in the optimisation problem.
struct LoadedSide {
  Vec<2> from{}, to{};               ///< the soil is on the left of the direction from `from` to `to`
  std::array<Vec<2>, 2> traction{};  ///< at both ends, linear in between [Pa]
};

/// Evaluates surcharges and water of the case at points of each side, independently of the mesh. Returns a sentence
/// with the place of the largest difference in traction; nullopt if the differences are rounding errors.
std::optional<std::string> find_wrong_load(const site::Site& site, const std::vector<LoadedSide>& sides);

}  // namespace talus::run
