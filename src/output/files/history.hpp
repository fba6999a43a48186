// SPDX-License-Identifier: MIT
#pragma once
// A table in comma-separated text to which a run appends rows, `time [s],kinetic_energy [J]`; and the meaning of its
// columns, which follows from the names that run/mpm/record/ writes.

#include <array>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/numbers.hpp"
#include "results/about.hpp"

namespace talus::output {

enum class HistoryQuantity {
  time,
  time_step,
  count,
  energy,  ///< term of the energy balance
  potential_energy,
  force_ratio,
  nodal_speed,
  mass,
  momentum,
  position,
  displacement,
  front,  ///< runout distance
  velocity,
  stress,
  strain,
  pore_pressure,
  suction,
  saturation,
  water_mass,
  water_flow,
  transpiration,
  state  ///< another state variable of a constitutive law
};

/// Terms of the energy balance: supplied energy and its forms.
enum class EnergyPart { external, kinetic, elastic, plastic, damping, walls, mapping, drag, pore_water, supports };

struct HistoryColumn {
  HistoryQuantity quantity = HistoryQuantity::state;
  std::optional<EnergyPart> part;  ///< for `energy` only
  std::string of;                  ///< monitor or side; empty for the whole body
  bool largest = false;            ///< maximum over all points
  char component = 0;              ///< 'x', 'y', 'z'; 0 for a scalar or the magnitude of a vector
  bool extensive = false;          ///< per metre of thickness in plane strain
};

/// Returns the meaning of a column such as "crest.displacement_x", "kinetic_energy" or "left.inflow".
HistoryColumn describe_column(const std::string& name);

}  // namespace talus::output

namespace talus::results {

template <>
inline constexpr auto words<output::EnergyPart> = std::array{
    "external", "kinetic", "elastic", "plastic", "damping", "walls", "mapping", "drag", "pore_water", "supports"};

template <>
inline constexpr auto words<output::HistoryQuantity> =
    std::array{"time",        "time_step",  "count",         "energy",        "potential_energy", "force_ratio",
               "nodal_speed", "mass",       "momentum",      "position",      "displacement",     "front",
               "velocity",    "stress",     "strain",        "pore_pressure", "suction",          "saturation",
               "water_mass",  "water_flow", "transpiration", "state"};

}  // namespace talus::results

namespace talus::output {

/// A column; its header is `name [unit]`.
struct Column {
  std::string name;
  std::string unit;
};

/// Writes a history row by row, with the shortest decimal numbers that read back as the same doubles.
class History {
 public:
  /// Starts a new file and replaces an existing one. The first column is the time [s]. Throws Error (cannot_write) with
  /// the file and the reason.
  static History start(const std::filesystem::path& path, const std::vector<Column>& columns);
  /// Continues the file of an interrupted run, or starts a new one if there is none. Throws Error (wrong_input) if the
  /// header differs.
  static History resume(const std::filesystem::path& path, const std::vector<Column>& columns);
  History(const History&) = delete;
  History& operator=(const History&) = delete;
  History(History&& other) noexcept;
  ~History();

  /// Appends a row, which is in the file on return. If the disk is full, the complete rows remain in the file and Error
  /// (cannot_write) is thrown.
  void append(std::span<const double> row);
  /// Records the present rows in the file list that a resumed run checks (base/file_list.hpp).
  void keep() const;
  /// Removes the rows after `time` [s] and an incomplete last row; a resumed run writes them again.
  void truncate_after(double time);

 private:
  History(std::filesystem::path path, std::size_t columns);
  void open();
  std::filesystem::path path_;
  std::size_t columns_;
  int file_ = -1;
};

/// A history by columns. Throws Error (wrong_input) with file and line if it cannot be read.
struct HistoryTable {
  std::vector<Column> columns;
  std::vector<std::vector<double>> values;  ///< [column][row]
};
HistoryTable read_history(const std::filesystem::path& path);

/// Quotes a field of comma-separated text (RFC 4180).
std::string quote_field(const std::string& text);
/// Returns `text` as the content of a cell, without control characters. A text that a spreadsheet would interpret as a
/// formula (= + - @) is preceded by an apostrophe.
std::string make_cell(const std::string& text);

}  // namespace talus::output
