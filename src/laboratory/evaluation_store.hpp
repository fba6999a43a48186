// SPDX-License-Identifier: MIT
#pragma once
// Evaluations of a calibration in a file of its folder, from which an interrupted search resumes.

#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace talus::laboratory {

/// Residuals at one set of parameters, or the reason for which it is refused.
struct Evaluation {
  std::vector<double> residuals;  ///< w (y_model - y)/σ
  std::string fault;              ///< empty if the set is accepted
};

/// Evaluations by their places in the ranges of the parameters. Every new one is appended to the file as a line of JSON
/// with all digits, so that a resumed search repeats the interrupted one bitwise and then continues it. Thread-safe.
class EvaluationStore {
 public:
  /// `input_hash`: of the case. With `resume` the evaluations of a file with the same hash are read; a last line that
  /// a kill has cut is left out. Throws Error (wrong_input) if the file belongs to another input.
  EvaluationStore(std::filesystem::path file, std::string input_hash, bool resume);

  std::optional<Evaluation> find(const std::vector<double>& places) const;
  /// Throws Error (cannot_write).
  void add(const std::vector<double>& places, const Evaluation& evaluation);
  /// Number of evaluations in the file.
  std::size_t size() const;
  const std::filesystem::path& file() const { return file_; }

 private:
  void read();
  void open();

  struct Closer {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::filesystem::path file_;
  std::string input_hash_;
  mutable std::mutex mutex_;
  std::map<std::vector<double>, Evaluation> known_;
  std::unique_ptr<std::FILE, Closer> out_;
};

}  // namespace talus::laboratory
