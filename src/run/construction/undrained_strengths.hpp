// SPDX-License-Identifier: MIT
#pragma once
// Undrained strengths of the soils at the end of a stage of construction, for limit equilibrium and limit analysis of a
// failure without drainage (docs/theory/26-consolidation.md).

#include <map>
#include <memory>
#include <string>

#include "input/case/case.hpp"
#include "lem/section/section.hpp"

namespace talus::run {

/// Soils with pore water and Mohr–Coulomb strength that does not dilate keep their mean effective stress s' in the
/// plane when they shear without drainage: s_u = c cos φ + s' sin φ. Soils without pore water and those with a total
/// strength keep theirs.
class UndrainedStrengths {
 public:
  /// `later`: the case at the end of the stage, with its effective stresses.
  explicit UndrainedStrengths(const input::Case& later);

  /// Returns true if no soil has another strength without drainage.
  bool empty() const { return fields_.empty() && fault_.empty(); }
  /// Returns why they are not known, as a sentence; empty if they are.
  const std::string& fault() const { return fault_; }
  /// Returns the case in which soils with pore water have the strength that F divides when c and tan φ are divided by
  /// F: F s_u(F) = cos φ_F (c + s' tan φ), tan φ_F = tan φ / F. `factor`: F.
  input::Case make_case(double factor) const;
  /// Returns a factor at which the strength of make_case(`factor`), divided by `found`, suffices where `found` is below
  /// `factor`: the strength falls with the factor that it belongs to.
  double correct(double found, double factor) const;

 private:
  /// s' at any place of a soil.
  class Field;

  /// Returns cos φ_F of a soil.
  double find_cosine(const std::string& name, double factor) const;

  const input::Case& later_;
  std::string fault_;
  std::map<std::string, std::shared_ptr<const Field>> fields_;  ///< by material
};

}  // namespace talus::run
