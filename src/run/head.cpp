// SPDX-License-Identifier: MIT
#include "run/head.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <ctime>

#include "base/lane.hpp"
#include "base/units.hpp"
#include "base/version.hpp"

namespace talus::run {
namespace {

std::string now_as_text() {
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  std::tm utc{};
  gmtime_r(&now, &utc);
  return fmt::format("{:04d}-{:02d}-{:02d}T{:02d}:{:02d}:{:02d}Z", utc.tm_year + 1900, utc.tm_mon + 1, utc.tm_mday,
                     utc.tm_hour, utc.tm_min, utc.tm_sec);
}

std::string find_machine() {
  char name[256] = {};
  gethostname(name, sizeof name - 1);
  return name;
}

}  // namespace

results::Project make_project(const input::Case& data) {
  const input::Project& p = data.project;
  return {data.title, p.name, p.client, p.author, p.checked_by, p.revision, p.notes};
}

results::Provenance make_provenance(const input::LoadedCase& loaded, const std::string& input_hash, int threads) {
  results::Provenance result;
  result.program = "talus";
  result.version = version;
  result.commit = commit;
  result.compiler = compiler;
  result.build_type = build_type;
  result.architecture = architecture;
  result.level = instruction_level;
  result.lane_width = lane_width;
  result.machine = find_machine();
  result.threads = threads;
  result.started = now_as_text();
  result.case_file = loaded.file;
  result.input_hash = input_hash;
  return result;
}

results::DisplayUnits make_display_units(const input::Output& output) {
  return {output.length_unit, output.displacement_unit, output.stress_unit};
}

results::RunResult begin_result(const input::LoadedCase& loaded, const std::string& input_hash, int threads) {
  results::RunResult run;
  run.title = loaded.data.title;
  run.project = make_project(loaded.data);
  run.provenance = make_provenance(loaded, input_hash, threads);
  run.units = make_display_units(loaded.data.output);
  for (const mesh::Polygon& p : loaded.data.mesh.polygons) run.outlines.emplace_back(p.points.begin(), p.points.end());
  run.input = loaded.echo;
  return run;
}

std::string format_length(const results::RunResult& run, double metres, int digits) {
  return fmt::format("{:.{}g} {}", metres / units::get_si_factor(run.units.length), digits, run.units.length);
}

}  // namespace talus::run
