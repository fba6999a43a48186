#include "run/run_case.hpp"

#include <chrono>
#include <cmath>

#include "base/atomic_file.hpp"
#include "base/error.hpp"
#include "ground/design_values.hpp"
#include "ground/ground_line.hpp"
#include "ground/plane_water.hpp"
#include "run/compare/compare.hpp"
#include "run/fem/solid_of_case.hpp"
#include "run/named_results.hpp"
#include "run/run_folder.hpp"
#include "run/static_methods.hpp"
#include "run/summary.hpp"

namespace talus::run {
namespace {

using nlohmann::json;
using Clock = std::chrono::steady_clock;

double find_seconds(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Fills "methods" and what follows from it: all that needs no further calculation but a few surfaces.
void add_comparison(const input::Case& data, const lem::Slope* slope, json statement, json& summary,
                    const RunOptions& options) {
  json block = compare_methods(data, slope, summary, options.folder, options.threads);
  if (const double factor = find_main_factor(summary); factor > 0) ground::state_over_design(statement, factor);
  block["partial_factors"] = std::move(statement);
  summary["methods"] = std::move(block);
}

/// A case without material points.
class StaticRun {
 public:
  StaticRun(const input::LoadedCase& loaded, const ground::DesignValues& design, const RunOptions& options,
            std::string hash)
      : loaded_(loaded), design_(design), options_(options), hash_(std::move(hash)) {}

  json run() {
    const auto start = Clock::now();
    StaticMethods methods(design_.data, hash_, options_);
    const mesh::Plan& plan = loaded_.data.mesh;
    summary_ = describe_case(loaded_, hash_, options_.threads);
    summary_["warnings"] = json::array();
    if (plan.dimension == 2 && !plan.polygons.empty())
      summary_["slope_height"] = ground::find_slope_height(plan, ground::find_ground(plan));
    bool is_open = false;
    const auto open_folder = [&] {
      clear_folder(options_);
      make_folder(options_.folder);
      is_open = true;
    };
    try {
      methods.run(open_folder);
      summary_["status"] = "finished";
      finish(methods, start);
    } catch (const Error& error) {
      if (options_.progress) options_.progress->clear();
      if (!is_open || summary_.value("status", "") == "finished") throw;
      summary_["status"] = error.code() == ExitCode::interrupted ? "interrupted" : "failed";
      summary_["error"] = error.what();
      try {
        finish(methods, start);
      } catch (const Error&) {  // the first error is the one to report
      }
      throw;
    }
    return summary_;
  }

 private:
  void finish(const StaticMethods& methods, Clock::time_point start) {
    methods.write_to(summary_);
    const double wall = find_seconds(start);
    summary_["timing"] = {{"wall", wall}, {"parts", json::array()}};
    for (const auto& [name, title] : {std::pair{"lem", "limit equilibrium"}, {"fem", "finite elements"}}) {
      if (!summary_.contains(name)) continue;
      summary_["timing"]["parts"].push_back(
          {{"name", name}, {"title", title}, {"seconds", summary_[name].value("seconds", 0.0)}});
    }
    add_comparison(design_.data, methods.slope(), design_.statement, summary_, options_);
    summary_["results"] = list_results(loaded_.data, summary_);
    summary_["comparisons"] = compare_results(loaded_.data, summary_);
    write_atomically(options_.folder / "summary.json", summary_.dump(2) + "\n");
  }

  const input::LoadedCase& loaded_;
  const ground::DesignValues& design_;
  const RunOptions& options_;
  std::string hash_;
  json summary_;
};

/// Material points with what else is asked for.
json run_with_points(const input::LoadedCase& loaded, const ground::DesignValues& design, const RunOptions& options,
                     const std::string& hash) {
  input::LoadedCase factored = loaded;
  factored.data = design.data;
  if (loaded.data.methods.size() == 1 && design.statement.is_null()) return run_points(loaded, options);
  if (input::uses(design.data, input::Method::fem)) check_methods(design.data);
  StaticMethods methods(design.data, hash, options);
  RunOptions with = options;
  with.begin = [&](json&) { methods.run([] {}); };
  with.end = [&](json& summary) {
    methods.write_to(summary);
    add_comparison(design.data, methods.slope(), design.statement, summary, options);
  };
  return run_points(factored, with);
}

/// What a finished run without material points compares with may have changed since.
json renew(json summary, const input::Case& data, const RunOptions& options) {
  const json before = summary;
  summary["title"] = data.title;
  summary["project"] = describe_project(data);
  summary["results"] = list_results(data, summary);
  summary["comparisons"] = compare_results(data, summary);
  if (summary != before) write_atomically(options.folder / "summary.json", summary.dump(2) + "\n");
  return summary;
}

}  // namespace

void check_methods(const input::Case& data) {
  if (input::uses(data, input::Method::lem) && !ground::needs_seepage(data)) prepare_slope(data);
  if (input::uses(data, input::Method::fem)) check_solid(data);
}

json run_case(const input::LoadedCase& loaded, const RunOptions& options) {
  const std::string hash = hash_input(loaded.echo.get());
  const ground::DesignValues design = ground::apply_partial_factors(loaded.data);
  if (input::uses(loaded.data, input::Method::mpm)) return run_with_points(loaded, design, options, hash);
  check_folder(loaded.data.initial, options);
  if (auto finished = load_finished(options, hash)) return renew(std::move(*finished), loaded.data, options);
  return StaticRun(loaded, design, options, hash).run();
}

}  // namespace talus::run
