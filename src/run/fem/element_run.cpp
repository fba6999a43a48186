#include "run/fem/element_run.hpp"

#include <fmt/format.h>

#include "base/atomic_file.hpp"
#include "base/error.hpp"
#include "results/json.hpp"
#include "run/fem/fields_vtu.hpp"

namespace talus::run {
namespace {

constexpr const char *file_name = "fem.json", *title = "finite elements";

}  // namespace

ElementRun::ElementRun(const input::Case& data, bool alone, const RunOptions& options, std::string input_hash)
    : data_(data), options_(options), hash_(std::move(input_hash)), alone_(alone) {}

void ElementRun::calculate(const std::function<void()>& open) {
  FemOptions options;
  options.threads = options_.threads;
  options.progress = options_.progress;
  options.ready = open;
  options.keep = [this](const ElementOutcome& outcome) { keep(outcome); };
  if (options_.resume) {
    auto known = results::find_file<results::ElementFile>(options_.folder / file_name);
    if (known && known->input_hash == hash_)
      options.known = ElementOutcome{std::move(known->summary), std::move(known->mesh)};
  }
  try {
    outcome_ = run_fem(data_, options);
  } catch (const Error& error) {
    if (options_.progress) options_.progress->clear();
    if (alone_ || error.code() == ExitCode::interrupted) throw;
    open();  // what the other methods found has to go somewhere
    outcome_.emplace();
    outcome_->result.error = error.what();
    outcome_->result.warnings = {fmt::format("{}: {}", title, error.what())};
  }
}

void ElementRun::tell(results::RunResult& run) const {
  if (!outcome_) return;
  const results::ElementResult& result = outcome_->result;
  run.elements = result;
  for (const std::string& warning : result.warnings)
    run.warnings.push_back(result.error ? warning : fmt::format("{}: {}", title, warning));
  for (const results::ElementRun& r : result.runs)
    for (const std::string& warning : r.warnings)
      run.warnings.push_back(
          fmt::format("{}, {}: {}", title, r.flow == results::Flow::associated ? "ψ = φ" : "ψ as given", warning));
  if (!run.seepage) run.seepage = result.seepage;
}

void ElementRun::keep(const ElementOutcome& outcome) const {
  results::write_file(options_.folder / file_name, results::ElementFile{hash_, outcome.result, outcome.mesh}, -1);
  write_atomically(options_.folder / "fem.vtu", write_vtu(outcome.mesh));
}

}  // namespace talus::run
