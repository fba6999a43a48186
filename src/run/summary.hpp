#pragma once
// What a run tells at its end, as JSON and as small tables. Numbers are SI; words and keys are the manual's.

#include <filesystem>
#include <nlohmann/json.hpp>

#include "input/read.hpp"
#include "mesh/quality.hpp"
#include "run/mpm/reduction/displacement_curve.hpp"
#include "run/mpm/reduction/frozen_factor.hpp"

namespace talus::run {

/// How a stage went.
struct StageReport {
  std::string name;
  StageEnd end = StageEnd::time;
  double start = 0, time = 0;  ///< [s]
  std::int64_t steps = 0;
  double time_step = 0;     ///< last [s]
  double displacement = 0;  ///< largest at the end [m]
  double force_ratio = 0, speed = 0;
  double wall = 0;  ///< [s]
};

nlohmann::json to_json(const StageReport& stage);
nlohmann::json to_json(const Criterion& criterion);
nlohmann::json to_json(const FrozenResult& frozen, double dilatancy_min, double dilatancy_max);
nlohmann::json to_json(const Runout& runout);
nlohmann::json to_json(const Profile& profile);

/// Program, build, machine and input: where a number comes from.
nlohmann::json describe_provenance(const input::LoadedCase& loaded, const std::string& input_hash, int threads);

/// What the summary of every run begins with, by whatever methods: title, project, provenance, units, outlines, input.
nlohmann::json describe_case(const input::LoadedCase& loaded, const std::string& input_hash, int threads);

/// The title block of the report.
nlohmann::json describe_project(const input::Case& data);

/// Mesh and points.
template <int D>
nlohmann::json describe_mesh(const mpm::Body<D>& body);

/// Wall seconds by part of the step.
nlohmann::json describe_timing(const mpm::Timing& timing);

/// Energy, momentum and mass: what came in, what is there, what was lost.
template <int D>
nlohmann::json describe_budgets(const mpm::Body<D>& body, const Vec<D>& gravity);

/// The curve block that `talus plot` draws, with every criterion.
nlohmann::json describe_curve(const CurveResult& curve, const std::optional<Bilinear>& bilinear,
                              const std::vector<Criterion>& criteria);

void write_profiles(const std::filesystem::path& path, const Profile& before, const Profile& after);

/// A few lines for the person at the terminal.
std::string write_digest(const nlohmann::json& summary);

}  // namespace talus::run
