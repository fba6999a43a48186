// SPDX-License-Identifier: MIT
#include "laboratory/evaluation_store.hpp"

#include <cerrno>
#include <nlohmann/json.hpp>
#include <sstream>

#include "base/atomic_file.hpp"
#include "base/error.hpp"
#include "base/user_file.hpp"

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
  constexpr std::uint64_t most = 1u << 30;
  if (!std::filesystem::exists(file_)) return;
  std::istringstream in(read_user_file(file_, most));
  std::string line;
  if (!std::getline(in, line)) return;
  // A line is an array, [hash] first and then [places, residuals, fault].
  const json head = json::parse(line, nullptr, false);
  if (!head.is_array() || head.size() != 1 || head[0] != input_hash_)
    fail_input("'{}' is that of another input: give another folder with -o, or leave --resume out", file_.string());
  while (std::getline(in, line)) {
    const json one = json::parse(line, nullptr, false);
    if (!one.is_array() || one.size() != 3 || !one[0].is_array() || !one[1].is_array() || !one[2].is_string()) continue;
    known_[one[0].get<std::vector<double>>()] = {one[1].get<std::vector<double>>(), one[2].get<std::string>()};
  }
}

/// Writes the file anew with what is known, so that no cut line remains in it, and opens it for more.
void EvaluationStore::open() {
  if (out_) return;
  make_folder(file_.parent_path());
  std::string text = write_line(json::array({input_hash_}));
  for (const auto& [places, found] : known_) text += write_line(json::array({places, found.residuals, found.fault}));
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
  const std::string line = write_line(json::array({places, evaluation.residuals, evaluation.fault}));
  if (std::fwrite(line.data(), 1, line.size(), out_.get()) != line.size() || std::fflush(out_.get()) != 0)
    throw_cannot_write(file_, errno, "the evaluations before are complete");
}

std::size_t EvaluationStore::size() const {
  const std::lock_guard lock(mutex_);
  return known_.size();
}

}  // namespace talus::laboratory
