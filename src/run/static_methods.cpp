#include "run/static_methods.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "base/atomic_file.hpp"
#include "base/error.hpp"
#include "base/interrupt.hpp"
#include "run/fem/fields_vtu.hpp"

namespace talus::run {
namespace {

using nlohmann::json;

constexpr const char *lem_file = "lem.json", *fem_file = "fem.json";

/// What a method leaves when it finds no answer.
json describe_failure(const char* words, const Error& error) {
  return {{"error", error.what()}, {"warnings", {fmt::format("{}: {}", words, error.what())}}};
}

}  // namespace

StaticMethods::StaticMethods(const input::Case& data, std::string input_hash, const RunOptions& options)
    : data_(data), hash_(std::move(input_hash)), options_(options) {
  if (input::uses(data, input::Method::lem)) prepared_ = prepare_slope(data);
}

void StaticMethods::run(const std::function<void()>& open_folder) {
  run_slices();
  if (input::uses(data_, input::Method::fem)) {
    run_elements(open_folder);
  } else {
    open_folder();
    if (lem_ && !is_kept_) keep(lem_file, lem_->block, lem_->file);
  }
}

void StaticMethods::run_slices() {
  if (!prepared_) return;
  if (json known = load(lem_file); known.is_object() && known.contains("summary")) {
    lem_ = LemResult{known.at("summary"), json::object()};
    is_kept_ = true;
    return;
  }
  if (options_.progress) options_.progress->show("limit equilibrium: searching for the critical slip surface");
  try {
    lem_ = run_lem(data_, *prepared_, options_.threads);
  } catch (const Error& error) {
    if (data_.methods.size() == 1 || error.code() == ExitCode::interrupted) throw;
    lem_ = LemResult{describe_failure("limit equilibrium", error), json::object()};
  }
  if (options_.progress) options_.progress->clear();
}

void StaticMethods::run_elements(const std::function<void()>& open_folder) {
  FemOptions options;
  options.threads = options_.threads;
  options.progress = options_.progress;
  if (json known = load(fem_file); known.is_object() && known.contains("summary")) {
    options.known.block = known.at("summary");
    known.erase("summary");
    known.erase("input_hash");
    options.known.file = std::move(known);
  }
  bool opened = false;
  const auto open = [&] {
    if (opened) return;
    open_folder();
    opened = true;
    if (lem_ && !is_kept_) keep(lem_file, lem_->block, lem_->file);
  };
  options.ready = open;
  options.keep = [&](const FemResult& result) {
    keep(fem_file, result.block, result.file);
    write_atomically(options_.folder / "fem.vtu", write_vtu(result.file));
  };
  try {
    fem_ = run_fem(data_, options);
  } catch (const Error& error) {
    if (options_.progress) options_.progress->clear();
    if (data_.methods.size() == 1 || error.code() == ExitCode::interrupted) throw;
    open();  // what the other methods found has to go somewhere
    fem_ = FemResult{describe_failure("finite elements", error), json::object()};
  }
}

void StaticMethods::write_to(json& summary) const {
  json warnings = summary.value("warnings", json::array());
  const auto add = [&](const char* name, const char* words, const json& block) {
    summary[name] = block;
    for (const json& w : block.value("warnings", json::array())) {
      const std::string text = w.get<std::string>();
      warnings.push_back(text.starts_with(words) ? text : fmt::format("{}: {}", words, text));
    }
  };
  if (lem_) add("lem", "limit equilibrium", lem_->block);
  if (fem_) {
    add("fem", "finite elements", fem_->block);
    for (const json& run : fem_->block.value("runs", json::array()))
      for (const json& w : run.at("warnings"))
        warnings.push_back(fmt::format("finite elements, {}: {}",
                                       run.at("flow") == "associated" ? "ψ = φ" : "ψ as given", w.get<std::string>()));
  }
  summary["warnings"] = warnings;
  // Of material points where they are asked for; of the meshes of the others else.
  if (summary.contains("seepage")) return;
  if (prepared_ && !prepared_->seepage.is_null())
    summary["seepage"] = prepared_->seepage;
  else if (fem_ && fem_->block.contains("seepage"))
    summary["seepage"] = fem_->block.at("seepage");
}

void StaticMethods::keep(const char* file, const json& block, json content) const {
  content["input_hash"] = hash_;
  content["summary"] = block;
  write_atomically(options_.folder / file, content.dump() + "\n");
}

json StaticMethods::load(const char* file) const {
  if (!options_.resume) return nullptr;
  std::ifstream in(options_.folder / file);
  if (!in) return nullptr;
  json content = json::parse(in, nullptr, false);
  if (content.is_discarded() || content.value("input_hash", "") != hash_) return nullptr;
  return content;
}

}  // namespace talus::run
