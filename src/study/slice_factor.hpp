// SPDX-License-Identifier: MIT
#pragma once
// The factor of safety by slices as a function of the sampled numbers: quick, over a fixed set of surfaces, or by a
// search of its own.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lem/search/candidates.hpp"
#include "lem/search/search.hpp"
#include "lem/section/section.hpp"
#include "study/sampled_numbers.hpp"

namespace talus::study {

// The effect of an uncertain number on slices: a soil, the earthquake, nothing, or the whole section.

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

class SliceFactor {
 public:
  /// Searches at the means and at corners of the distributions, and keeps the surfaces that may be critical. Throws
  /// what run::make_section() and lem::search() do at the means.
  SliceFactor(const input::LoadedCase& base, const std::vector<input::Override>& overrides,
              const SampledNumbers& sampled, int threads);
  /// The same on surfaces that were kept before, without a search.
  SliceFactor(const input::LoadedCase& base, const std::vector<input::Override>& overrides,
              const SampledNumbers& sampled, const std::vector<lem::Surface>& surfaces);

  /// Whether every sample needs its own section and search.
  bool is_full() const { return numbers_.changes_section(); }
  lem::Method method() const { return options_.methods.front(); }
  const SliceNumbers& numbers() const { return numbers_; }
  /// Surfaces that every sample is evaluated on; 0 with searches.
  int count_surfaces() const { return candidates_ ? candidates_->count() : 0; }
  std::vector<lem::Surface> list_surfaces() const;
  /// Combinations of values that were searched, besides the means.
  int count_corners() const { return corners_; }

  /// Memory of one thread.
  struct Workspace {
    lem::Candidates::Workspace candidates;
    std::vector<lem::Soil> soils;
  };
  /// The smallest factor with these values; nothing where no surface is admissible. Safe to call from many threads.
  std::optional<double> find(const std::vector<double>& values, Workspace& work) const;

  struct Searched {
    double factor = 0;
    std::vector<lem::Surface> surfaces;  ///< critical ones and local minima
  };
  /// The same by a search for these values alone.
  std::optional<Searched> search(const std::vector<double>& values) const;
  /// Keeps more surfaces. Not while others call find().
  void add(const std::vector<lem::Surface>& surfaces);

 private:
  bool searches() const { return base_.data.lem.search != input::SurfaceSearch::none; }
  std::vector<lem::Section> make_corners() const;

  const input::LoadedCase& base_;
  const std::vector<input::Override>& overrides_;
  const SampledNumbers& sampled_;
  SliceNumbers numbers_;
  lem::SearchOptions options_;
  std::unique_ptr<lem::Slope> slope_;  ///< at the means
  std::unique_ptr<lem::Candidates> candidates_;
  int corners_ = 0;
};

}  // namespace talus::study
