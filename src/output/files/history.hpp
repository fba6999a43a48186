// SPDX-License-Identifier: MIT
#pragma once
// A table that grows while a run goes on, as comma-separated text: `time [s],kinetic_energy [J]`.

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace talus::output {

/// One column: header `name [unit]`.
struct Column {
  std::string name;
  std::string unit;
};

/// Rows reach the file one by one, each with the shortest digits that give the same double back.
class History {
 public:
  /// A new file; what was there is replaced. The first column is the time [s].
  /// Throws Error (cannot_write) naming the file and the reason.
  static History start(const std::filesystem::path& path, const std::vector<Column>& columns);
  /// Goes on with the file of an interrupted run; starts a new one when there is none.
  /// Throws Error (wrong_input) when its header is another one.
  static History resume(const std::filesystem::path& path, const std::vector<Column>& columns);
  History(const History&) = delete;
  History& operator=(const History&) = delete;
  History(History&& other) noexcept;
  ~History();

  /// Writes a row: it is in the file when this returns. When the disk is full the file keeps its whole rows and
  /// Error (cannot_write) is thrown.
  void append(std::span<const double> row);
  /// Lists the rows so far as what a resumed run expects (base/file_list.hpp).
  void keep() const;
  /// Drops the rows after `time` [s] and a last row that was cut off; a run that goes on from there writes them again.
  void truncate_after(double time);

 private:
  History(std::filesystem::path path, std::size_t columns);
  void open();
  std::filesystem::path path_;
  std::size_t columns_;
  int file_ = -1;
};

/// A history as columns. Throws Error (wrong_input) naming the file and line when it cannot be read.
struct HistoryTable {
  std::vector<Column> columns;
  std::vector<std::vector<double>> values;  ///< [column][row]
};
HistoryTable read_history(const std::filesystem::path& path);

/// The shortest text that reads back as `value`; nan, inf and -inf for what is no number.
std::string to_shortest(double value);
/// A text as a field of comma-separated text (RFC 4180).
std::string quote_field(const std::string& text);
/// `text` as the content of a cell: without control characters, and with a single quotation mark in front where a
/// spreadsheet would take it for a formula (= + - @).
std::string make_cell(const std::string& text);

}  // namespace talus::output
