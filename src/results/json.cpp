// SPDX-License-Identifier: MIT
#include "results/json.hpp"

#include "base/atomic_file.hpp"
#include "base/user_file.hpp"
#include "results/json_visitors.hpp"
#include "results/laboratory.hpp"
#include "results/run.hpp"
#include "results/study.hpp"
#include "results/study_jobs.hpp"

namespace talus::results {

template <class T>
nlohmann::json to_json(const T& result) {
  return write_value(result);
}

template <class T>
T from_json(const nlohmann::json& tree, const std::string& file) {
  T result{};
  read_value(tree, result, JsonPlace(file));
  return result;
}

template <class T>
std::optional<T> read_file(const std::filesystem::path& path) {
  std::string text;
  if (const auto fault = try_user_file(path, largest_file::result, text)) {
    if (fault->is_missing) return std::nullopt;
    throw Error(ExitCode::wrong_input, fmt::format("cannot read '{}': {}", path.string(), fault->why));
  }
  nlohmann::json tree;
  try {
    tree = nlohmann::json::parse(text);
  } catch (const nlohmann::json::exception& error) {
    throw Error(ExitCode::wrong_input, fmt::format("cannot read '{}': {}", path.string(), error.what()));
  }
  if constexpr (!is_vector<T>)
    if (!tree.is_object())
      throw Error(ExitCode::wrong_input,
                  fmt::format("'{}' is no result of Talus: it should hold one JSON object", path.string()));
  return from_json<T>(tree, path.string());
}

template <class T>
std::optional<T> find_file(const std::filesystem::path& path) {
  try {
    return read_file<T>(path);
  } catch (const Error&) {
    return std::nullopt;
  }
}

template <class T>
void write_file(const std::filesystem::path& path, const T& result, int indent, const std::string& safe) {
  write_atomically(path, to_json(result).dump(indent) + "\n", safe);
}

#define TALUS_JSON(T)                                                   \
  template nlohmann::json to_json<T>(const T&);                         \
  template T from_json<T>(const nlohmann::json&, const std::string&);   \
  template std::optional<T> read_file<T>(const std::filesystem::path&); \
  template std::optional<T> find_file<T>(const std::filesystem::path&); \
  template void write_file<T>(const std::filesystem::path&, const T&, int, const std::string&);
TALUS_JSON(RunResult)
TALUS_JSON(SliceFile)
TALUS_JSON(TimelineFile)
TALUS_JSON(ElementFile)
TALUS_JSON(BoundsFile)
TALUS_JSON(WaterFields)
TALUS_JSON(Trial)
TALUS_JSON(std::vector<Trial>)
TALUS_JSON(SlipLine)
TALUS_JSON(TrialOutcome)
TALUS_JSON(StageRecord)
TALUS_JSON(StudyResult)
TALUS_JSON(StudyJobs)
TALUS_JSON(JobSurfaces)
TALUS_JSON(JobResult)
TALUS_JSON(PointTests)
TALUS_JSON(Calibration)
#undef TALUS_JSON

// Parts of a result that the page of a report is given as they are.
#define TALUS_JSON(T) template nlohmann::json to_json<T>(const T&);
TALUS_JSON(Project)
TALUS_JSON(Provenance)
TALUS_JSON(StepSeconds)
TALUS_JSON(std::vector<TimedPart>)
TALUS_JSON(std::vector<Comparison>)
TALUS_JSON(std::vector<Criterion>)
TALUS_JSON(Motion)
TALUS_JSON(SliceTable)
TALUS_JSON(StandingWater)
TALUS_JSON(Circle)
TALUS_JSON(Sampling)
TALUS_JSON(PointGroup)
TALUS_JSON(std::vector<ExtrapolatedFactor>)
#undef TALUS_JSON

}  // namespace talus::results
