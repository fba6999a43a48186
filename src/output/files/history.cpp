// SPDX-License-Identifier: MIT
#include "output/files/history.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <map>
#include <sstream>
#include <string_view>
#include <utility>

#include "base/atomic_file.hpp"
#include "base/error.hpp"
#include "base/file_list.hpp"
#include "base/text.hpp"
#include "base/user_file.hpp"

namespace talus::output {

namespace {

struct Known {
  HistoryQuantity quantity;
  bool extensive = false;
  std::optional<EnergyPart> part{};
};

/// Known columns, by name without monitor, "largest_" and component.
const std::map<std::string_view, Known>& list_known() {
  using enum HistoryQuantity;
  static const std::map<std::string_view, Known> known{
      {"time", {time}},
      {"step", {count}},
      {"time_step", {time_step}},
      {"kinetic_energy", {energy, true, EnergyPart::kinetic}},
      {"potential_energy", {potential_energy, true}},
      {"elastic_energy", {energy, true, EnergyPart::elastic}},
      {"plastic_work", {energy, true, EnergyPart::plastic}},
      {"damping_work", {energy, true, EnergyPart::damping}},
      {"wall_work", {energy, true, EnergyPart::walls}},
      {"mapping_loss", {energy, true, EnergyPart::mapping}},
      {"drag_work", {energy, true, EnergyPart::drag}},
      {"pore_water_work", {energy, true, EnergyPart::pore_water}},
      {"support_work", {energy, true, EnergyPart::supports}},
      {"external_work", {energy, true, EnergyPart::external}},
      {"force_ratio", {force_ratio}},
      {"nodal_speed", {nodal_speed}},
      {"points", {count}},
      {"mass", {mass, true}},
      {"momentum", {momentum, true}},
      {"centre", {position}},
      {"displacement", {displacement}},
      {"front_advance", {front}},
      {"toe_distance", {front}},
      {"velocity", {velocity}},
      {"mean_stress", {stress}},
      {"deviatoric_stress", {stress}},
      {"preconsolidation_pressure", {stress}},
      {"deviatoric_strain", {strain}},
      {"root_activation_strain", {strain}},
      {"separation", {strain}},
      {"pore_pressure", {pore_pressure}},
      {"suction", {suction}},
      {"saturation", {saturation}},
      {"water_mass", {water_mass, true}},
      {"inflow", {water_flow, true}},
      {"outflow", {water_flow, true}},
      {"runoff", {water_flow, true}},
      {"transpiration", {transpiration, true}},
  };
  return known;
}

}  // namespace

HistoryColumn describe_column(const std::string& name) {
  constexpr std::string_view largest = "largest_";
  HistoryColumn column;
  std::string_view rest = name;
  if (const std::size_t dot = name.rfind('.'); dot != std::string::npos) {
    column.of = name.substr(0, dot);
    rest.remove_prefix(dot + 1);
  }
  if (rest.starts_with(largest)) {
    column.largest = true;
    rest.remove_prefix(largest.size());
  }
  auto known = list_known().find(rest);
  if (known == list_known().end() && rest.size() > 2 && rest[rest.size() - 2] == '_') {
    known = list_known().find(rest.substr(0, rest.size() - 2));
    if (known != list_known().end()) column.component = rest.back();
  }
  if (known == list_known().end()) return column;
  column.quantity = known->second.quantity;
  column.part = known->second.part;
  column.extensive = known->second.extensive;
  return column;
}

namespace {

namespace fs = std::filesystem;

const std::string safe_clause = "the rows written before are whole";

std::string make_header(const std::vector<Column>& columns) {
  std::string text;
  for (const Column& c : columns) text += fmt::format("{}{} [{}]", text.empty() ? "" : ",", c.name, c.unit);
  return text + "\n";
}

std::string read_text_file(const fs::path& path) {
  return read_user_file(path, largest_file::result);
}

double parse_number(const std::string& text, const fs::path& path, int line) {
  double value = 0;
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (failure != std::errc() || end != text.data() + text.size())
    fail_input("{}:{}: error: '{}' is not a number", path.string(), line, text);
  return value;
}

Column parse_column(const std::string& text) {
  const std::size_t open = text.rfind(" [");
  if (open == std::string::npos || text.back() != ']') return {text, ""};
  return {text.substr(0, open), text.substr(open + 2, text.size() - open - 3)};
}

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
  return parts;
}

}  // namespace

History::History(fs::path path, std::size_t columns) : path_(std::move(path)), columns_(columns) {}
History::History(History&& other) noexcept
    : path_(std::move(other.path_)), columns_(other.columns_), file_(std::exchange(other.file_, -1)) {}
History::~History() {
  if (file_ < 0) return;
  try {
    list_grown(path_, false);
  } catch (const Error&) {  // the rows are in the file nevertheless
  }
  ::close(file_);
}

void History::open() {
  if (file_ >= 0) ::close(file_);
  list_growing(path_);
  file_ = ::open(path_.c_str(), O_WRONLY | O_APPEND | O_NOFOLLOW | O_CLOEXEC);
  if (file_ < 0) throw_cannot_write(path_, errno, safe_clause);
}

History History::start(const fs::path& path, const std::vector<Column>& columns) {
  write_atomically(path, make_header(columns));
  History history(path, columns.size());
  history.open();
  return history;
}

History History::resume(const fs::path& path, const std::vector<Column>& columns) {
  if (!fs::exists(path)) return start(path, columns);
  const std::string text = read_text_file(path), header = make_header(columns);
  if (!text.starts_with(header))
    fail_input("cannot continue '{}': its columns are '{}' where '{}' was expected", path.string(),
               text.substr(0, text.find('\n')), header.substr(0, header.size() - 1));
  // The next row must not be appended to an incomplete row of a killed run.
  const std::size_t whole = text.rfind('\n') + 1;
  if (whole != text.size()) write_atomically(path, text.substr(0, whole), safe_clause);
  History history(path, columns.size());
  history.open();
  return history;
}

void History::append(std::span<const double> row) {
  if (row.size() != columns_)
    throw Error(ExitCode::internal_error, "a row of '{}' has {} values, not {}", path_.string(), row.size(), columns_);
  std::string line;
  for (const double value : row) {
    if (!line.empty()) line += ',';
    line += write_shortest(value);
  }
  line += '\n';
  const off_t before = ::lseek(file_, 0, SEEK_END);
  for (std::size_t done = 0; done < line.size();) {
    const ssize_t n = ::write(file_, line.data() + done, line.size() - done);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) {
      const int reason = errno;
      static_cast<void>(::ftruncate(file_, before) == 0);
      throw_cannot_write(path_, reason, safe_clause);
    }
    done += static_cast<std::size_t>(n);
  }
}

void History::keep() const {
  list_grown(path_, true);
}

void History::truncate_after(double time) {
  const std::string text = read_text_file(path_);
  std::size_t begin = std::min(text.find('\n'), text.size() - 1) + 1;
  std::string kept = text.substr(0, begin);
  for (int line = 2; begin < text.size(); ++line) {
    const std::size_t end = text.find('\n', begin);
    if (end == std::string::npos) break;
    const std::string row = text.substr(begin, end - begin);
    if (parse_number(row.substr(0, row.find(',')), path_, line) <= time) kept += row + "\n";
    begin = end + 1;
  }
  if (kept == text) return;
  write_atomically(path_, kept, safe_clause);
  open();
}

HistoryTable read_history(const fs::path& path) {
  HistoryTable table;
  const std::string text = read_text_file(path);
  const std::vector<std::string> lines = split(text.substr(0, text.rfind('\n') + 1), '\n');
  if (lines.empty()) fail_input("cannot read '{}': it is empty", path.string());
  for (const std::string& title : split(lines[0], ',')) table.columns.push_back(parse_column(title));
  table.values.resize(table.columns.size());
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const std::vector<std::string> cells = split(lines[i], ',');
    if (cells.size() != table.columns.size())
      fail_input("{}:{}: error: {} values where {} columns were expected", path.string(), i + 1, cells.size(),
                 table.columns.size());
    for (std::size_t c = 0; c < cells.size(); ++c)
      table.values[c].push_back(parse_number(cells[c], path, static_cast<int>(i) + 1));
  }
  return table;
}

std::string make_cell(const std::string& text) {
  std::string cell = make_printable(text);
  if (cell.empty() || std::string_view("=+-@").find(cell.front()) == std::string_view::npos) return cell;
  double number = 0;
  const char *begin = cell.data() + (cell.front() == '+' ? 1 : 0), *end = cell.data() + cell.size();
  const bool is_number = std::from_chars(begin, end, number).ptr == end;
  return is_number ? cell : "'" + cell;
}

std::string quote_field(const std::string& text) {
  std::string cell = make_cell(text);
  if (cell.find_first_of(",\"") == std::string::npos) return cell;
  std::string field = "\"";
  for (const char c : cell) field += c == '"' ? "\"\"" : std::string(1, c);
  return field + "\"";
}

}  // namespace talus::output
