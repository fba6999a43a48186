// SPDX-License-Identifier: MIT
#pragma once
// A table that grows while a run goes on, as comma-separated text: `time [s],kinetic_energy [J]`.

#include <array>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "results/about.hpp"

// What the columns of histories and monitors hold. Their names are those that run/mpm/record/ writes; a CSV file has no
// room for more.

namespace talus::output {

enum class HistoryQuantity {
  time,
  time_step,
  count,
  energy,  ///< what the balance of energy adds up
  potential_energy,
  force_ratio,
  nodal_speed,
  mass,
  momentum,
  position,
  displacement,
  front,  ///< how far the soil has run
  velocity,
  stress,
  strain,
  pore_pressure,
  suction,
  saturation,
  water_mass,
  water_flow,
  transpiration,
  state  ///< another variable of a soil model
};

/// Terms of the balance of energy: energy that enters the body, and its forms.
enum class EnergyPart { external, kinetic, elastic, plastic, damping, walls, mapping, drag, pore_water };

struct HistoryColumn {
  HistoryQuantity quantity = HistoryQuantity::state;
  std::optional<EnergyPart> part;  ///< of energy
  std::string of;                  ///< monitor or side; empty: the whole body
  bool largest = false;            ///< of all points
  char component = 0;              ///< 'x', 'y', 'z'; 0: a scalar, or the length of a vector
  bool extensive = false;          ///< in plane strain per metre of thickness
};

/// "crest.displacement_x", "kinetic_energy", "left.inflow".
HistoryColumn describe_column(const std::string& name);

}  // namespace talus::output

namespace talus::results {

template <>
inline constexpr auto words<output::EnergyPart> =
    std::array{Word{output::EnergyPart::external, "external"},    Word{output::EnergyPart::kinetic, "kinetic"},
               Word{output::EnergyPart::elastic, "elastic"},      Word{output::EnergyPart::plastic, "plastic"},
               Word{output::EnergyPart::damping, "damping"},      Word{output::EnergyPart::walls, "walls"},
               Word{output::EnergyPart::mapping, "mapping"},      Word{output::EnergyPart::drag, "drag"},
               Word{output::EnergyPart::pore_water, "pore_water"}};

template <>
inline constexpr auto words<output::HistoryQuantity> =
    std::array{Word{output::HistoryQuantity::time, "time"},
               Word{output::HistoryQuantity::time_step, "time_step"},
               Word{output::HistoryQuantity::count, "count"},
               Word{output::HistoryQuantity::energy, "energy"},
               Word{output::HistoryQuantity::potential_energy, "potential_energy"},
               Word{output::HistoryQuantity::force_ratio, "force_ratio"},
               Word{output::HistoryQuantity::nodal_speed, "nodal_speed"},
               Word{output::HistoryQuantity::mass, "mass"},
               Word{output::HistoryQuantity::momentum, "momentum"},
               Word{output::HistoryQuantity::position, "position"},
               Word{output::HistoryQuantity::displacement, "displacement"},
               Word{output::HistoryQuantity::front, "front"},
               Word{output::HistoryQuantity::velocity, "velocity"},
               Word{output::HistoryQuantity::stress, "stress"},
               Word{output::HistoryQuantity::strain, "strain"},
               Word{output::HistoryQuantity::pore_pressure, "pore_pressure"},
               Word{output::HistoryQuantity::suction, "suction"},
               Word{output::HistoryQuantity::saturation, "saturation"},
               Word{output::HistoryQuantity::water_mass, "water_mass"},
               Word{output::HistoryQuantity::water_flow, "water_flow"},
               Word{output::HistoryQuantity::transpiration, "transpiration"},
               Word{output::HistoryQuantity::state, "state"}};

}  // namespace talus::results

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
