// SPDX-License-Identifier: MIT
#pragma once
// The effect of an uncertain number on slices: a soil, the earthquake, nothing, or the whole section.

#include <string>
#include <vector>

#include "lem/section/section.hpp"
#include "study/sampled_numbers.hpp"

namespace talus::study {

/// Soils and accelerations as functions of the sampled values, without reading the case again.
class SliceNumbers {
 public:
  SliceNumbers(const input::LoadedCase& base, const std::vector<input::Override>& overrides,
               const SampledNumbers& sampled);

  /// Whether some number changes more than soils and accelerations, so that every sample needs its own section.
  bool changes_section() const { return !section_keys_.empty(); }
  const std::vector<std::string>& section_keys() const { return section_keys_; }
  /// Numbers that slices do not know.
  const std::vector<std::string>& idle_keys() const { return idle_keys_; }

  /// The case at the distributions' means.
  const lem::Section& middle() const { return middle_; }
  const std::vector<std::string>& notes() const { return notes_; }
  /// The section with these values. Its geometry and water are those of the middle.
  lem::Section make_section(const std::vector<double>& values) const;
  /// The same for soils and accelerations alone.
  void apply(const std::vector<double>& values, std::vector<lem::Soil>& soils, double& horizontal,
             double& vertical) const;

 private:
  enum class Part { cohesion, friction, gradient, level, ratio, phi_b, weight, horizontal, vertical };
  struct Link {
    std::size_t number = 0;
    Part part = Part::cohesion;
    int soil = -1;
    double factor = 1;          ///< SI per unit of the key
    double moist = 0, sat = 0;  ///< weight: change of both unit weights per unit of the key
  };
  void add_link(Link link, const std::string& material);

  lem::Section middle_;
  std::vector<double> middle_values_;
  std::vector<Link> links_;
  std::vector<std::string> section_keys_, idle_keys_, notes_;
};

}  // namespace talus::study
