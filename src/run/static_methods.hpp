#pragma once
// Slices and finite elements of one run: calculated or taken from what an interrupted run has left, kept in the folder.

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "run/fem/run_fem.hpp"
#include "run/lem/run_lem.hpp"
#include "run/mpm/run_points.hpp"

namespace talus::run {

/// Both, as far as the case asks for them.
class StaticMethods {
 public:
  /// Prepares the slope; throws what prepare_slope() throws. `data`: with design values where there are partial
  /// factors.
  StaticMethods(const input::Case& data, std::string input_hash, const RunOptions& options);

  /// Calculates. `open_folder` is called once before anything is written. Errors of a method that is not the only one
  /// are noted in its block.
  void run(const std::function<void()>& open_folder);

  /// Blocks, times and warnings into the summary.
  void write_to(nlohmann::json& summary) const;

  const lem::Slope* slope() const { return prepared_ ? prepared_->slope.get() : nullptr; }

 private:
  void run_slices();
  void run_elements(const std::function<void()>& open_folder);
  void keep(const char* file, const nlohmann::json& block, nlohmann::json content) const;
  nlohmann::json load(const char* file) const;

  const input::Case& data_;
  std::string hash_;
  const RunOptions& options_;
  std::optional<PreparedSlope> prepared_;
  std::optional<LemResult> lem_;
  std::optional<FemResult> fem_;
  bool is_kept_ = false;  ///< the slices are those of an earlier run
};

}  // namespace talus::run
