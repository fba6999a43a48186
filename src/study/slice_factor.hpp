// SPDX-License-Identifier: MIT
#pragma once
// The LEM factor of safety as a function of the sampled numbers: on a fixed set of surfaces, which is quick, or by a
// search for each sample.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lem/search/candidates.hpp"
#include "lem/search/search.hpp"
#include "lem/section/section.hpp"
#include "study/sampled_numbers.hpp"

namespace talus::study {

// An uncertain number affects a soil, the earthquake, nothing, or the whole section.

/// Soils and accelerations as functions of the sampled values, without reading the case again.
class SliceNumbers {
 public:
  SliceNumbers(const input::LoadedCase& base, const std::vector<input::Override>& overrides,
               const SampledNumbers& sampled);

  /// Returns true if some number affects more than soils and accelerations, so that every sample needs its own
  /// section.
  bool changes_section() const { return !section_keys_.empty(); }
  const std::vector<std::string>& section_keys() const { return section_keys_; }
  /// Keys of numbers that LEM does not use.
  const std::vector<std::string>& idle_keys() const { return idle_keys_; }

  /// Section of the case at the means of the distributions.
  const lem::Section& middle() const { return middle_; }
  const std::vector<std::string>& notes() const { return notes_; }
  /// Returns the section with these values. Its geometry and water are those of the middle.
  lem::Section make_section(const std::vector<double>& values) const;
  /// Sets soils and accelerations alone.
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
  /// Searches at the means and at corners of the distributions, and stores the surfaces that may be critical. Throws
  /// what run::make_section() and lem::search() throw at the means.
  SliceFactor(const input::LoadedCase& base, const std::vector<input::Override>& overrides,
              const SampledNumbers& sampled, int threads);
  /// Uses stored surfaces instead of a search.
  SliceFactor(const input::LoadedCase& base, const std::vector<input::Override>& overrides,
              const SampledNumbers& sampled, const std::vector<lem::Surface>& surfaces);

  /// Returns true if every sample needs its own section and search.
  bool is_full() const { return numbers_.changes_section(); }
  lem::Method method() const { return options_.methods.front(); }
  const SliceNumbers& numbers() const { return numbers_; }
  /// Number of surfaces on which every sample is evaluated; 0 with searches.
  int count_surfaces() const { return candidates_ ? candidates_->count() : 0; }
  std::vector<lem::Surface> list_surfaces() const;
  /// Number of searched combinations of values besides the means.
  int count_corners() const { return corners_; }

  /// Working memory of one thread.
  struct Workspace {
    lem::Candidates::Workspace candidates;
    std::vector<lem::Soil> soils;
  };
  /// Returns the smallest factor with these values; nullopt if no surface is admissible. Thread-safe.
  std::optional<double> find(const std::vector<double>& values, Workspace& work) const;

  struct Searched {
    double factor = 0;
    std::vector<lem::Surface> surfaces;  ///< critical surfaces and local minima
  };
  /// Returns the factor of a search for these values.
  std::optional<Searched> search(const std::vector<double>& values) const;
  /// Adds surfaces. Must not run concurrently with find().
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
