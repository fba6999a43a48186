// SPDX-License-Identifier: MIT
#include "laboratory/evaluation_store.hpp"

#include <cerrno>
#include <fstream>
#include <nlohmann/json.hpp>

#include "base/atomic_file.hpp"
#include "base/error.hpp"

namespace talus::laboratory {
namespace {

using nlohmann::json;

std::string write_line(const json& value) {
  return value.dump(-1, ' ', false, json::error_handler_t::replace) + "\n";
}

}  // namespace

EvaluationStore::EvaluationStore(std::filesystem::path file, std::string input_hash, bool resume)
    : file_(std::move(file)), input_hash_(std::move(input_hash)) {
  if (resume) read();
}

void EvaluationStore::read() {
  std::ifstream in(file_);
  std::string line;
  if (!in || !std::getline(in, line)) return;
  const json head = json::parse(line, nullptr, false);
  if (!head.is_object() || head.value("input_hash", "") != input_hash_)
    fail_input("'{}' is that of another input: give another folder with -o, or leave --resume out", file_.string());
  while (std::getline(in, line)) {
    const json one = json::parse(line, nullptr, false);
    const bool is_whole = one.is_object() && one.contains("places") && one.contains("residuals") &&
                          one.contains("fault") && one["places"].is_array() && one["residuals"].is_array();
    if (!is_whole) continue;
    known_[one["places"].get<std::vector<double>>()] = {one["residuals"].get<std::vector<double>>(),
                                                        one["fault"].get<std::string>()};
  }
}

/// Writes the file anew with what is known, so that no cut line remains in it, and opens it for more.
void EvaluationStore::open() {
  if (out_) return;
  make_folder(file_.parent_path());
  std::string text = write_line({{"input_hash", input_hash_}});
  for (const auto& [places, found] : known_)
    text += write_line({{"places", places}, {"residuals", found.residuals}, {"fault", found.fault}});
  write_atomically(file_, text);
  out_.reset(std::fopen(file_.c_str(), "a"));
  if (!out_) throw_cannot_write(file_, errno);
}

std::optional<Evaluation> EvaluationStore::find(const std::vector<double>& places) const {
  const std::lock_guard lock(mutex_);
  const auto found = known_.find(places);
  return found == known_.end() ? std::nullopt : std::optional(found->second);
}

void EvaluationStore::add(const std::vector<double>& places, const Evaluation& evaluation) {
  const std::lock_guard lock(mutex_);
  open();
  known_[places] = evaluation;
  const std::string line =
      write_line({{"places", places}, {"residuals", evaluation.residuals}, {"fault", evaluation.fault}});
  if (std::fwrite(line.data(), 1, line.size(), out_.get()) != line.size() || std::fflush(out_.get()) != 0)
    throw_cannot_write(file_, errno, "the evaluations before are complete");
}

std::size_t EvaluationStore::size() const {
  const std::lock_guard lock(mutex_);
  return known_.size();
}

}  // namespace talus::laboratory
