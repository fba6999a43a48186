// SPDX-License-Identifier: MIT
#pragma once
// Visitor that converts described structs to tables. Only results/tables.cpp and its test include this header.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <deque>
#include <map>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/json_tree.hpp"
#include "results/about.hpp"
#include "results/shapes.hpp"
#include "results/tables.hpp"

namespace talus::results {

/// Structs that no table includes.
template <class T>
inline constexpr bool is_left_out = std::is_same_v<T, JsonTree>;
/// Structs whose lists are the columns of one table, such as those of slices.
template <class T>
inline constexpr bool has_columns = false;
/// Structs of a list whose own lists of numbers, as long as the first of them, are the columns of one table.
template <class T>
inline constexpr bool has_own_columns = false;
/// Structs of the overview.
template <class T>
inline constexpr bool is_in_head = false;

template <class T>
inline constexpr bool is_plain = std::is_arithmetic_v<T> || std::is_enum_v<T> || std::is_same_v<T, std::string>;
/// Entries of lists that are cells of one row.
template <class T>
inline constexpr bool is_entry = is_plain<T>;
template <class T>
inline constexpr bool is_entry<std::optional<T>> = is_plain<T>;
template <class T, std::size_t N>
inline constexpr bool is_entry<std::array<T, N>> = is_plain<T>;
template <class T>
inline constexpr bool is_struct = !is_plain<T> && !is_optional<T> && !is_vector<T> && !is_array<T> && !is_map<T>;

/// A value of the rows above a list, repeated in each of its rows.
struct Lead {
  Column head;
  Cell cell;
};

/// The tables of one result, by name.
class TableSet {
 public:
  TableSet(const ShownUnits& units, std::size_t dimension) : units_(units), dimension_(dimension) {}

  Table& find(const std::string& name, const std::string& title) {
    const auto [at, is_new] = by_name_.try_emplace(name, nullptr);
    if (is_new) {
      at->second = &tables_.emplace_back();
      at->second->name = name;
      at->second->title = title;
    }
    return *at->second;
  }

  /// Adds a row that begins with `leads` and returns its number.
  std::size_t add_row(Table& table, const std::vector<Lead>& leads) const {
    const std::size_t row = table.rows++;
    for (Column& column : table.columns) column.cells.resize(table.rows);
    for (const Lead& lead : leads) set(table, row, lead.head, lead.cell);
    return row;
  }

  /// Sets a cell; the first one of a key makes its column.
  void set(Table& table, std::size_t row, const Column& head, Cell cell) const {
    auto at = table.columns.begin();
    while (at != table.columns.end() && at->key != head.key) ++at;
    if (at == table.columns.end()) {
      at = table.columns.insert(at, head);
      at->cells.resize(table.rows);
    }
    at->cells[row] = std::move(cell);
  }

  template <class T>
  void set_value(Table& table, std::size_t row, Column head, const std::string& stored, const T& value) const {
    const ShownUnit unit = find_shown_unit(stored, units_, dimension_);
    head.unit = unit.name;
    Cell cell;
    if constexpr (std::is_enum_v<T>) {
      cell = std::string(to_word(value));
    } else if constexpr (std::is_integral_v<T> && !std::is_same_v<T, bool>) {
      constexpr auto most = std::uint64_t{1} << 53;  // larger ones are no doubles
      head.counts = true;
      if (static_cast<std::uint64_t>(value < 0 ? -value : value) <= most)
        cell = static_cast<double>(value);
      else
        cell = std::to_string(value);
    } else if constexpr (std::is_floating_point_v<T>) {
      if (std::isfinite(value)) cell = value / unit.si;
    } else {
      bool has_value = true;
      if constexpr (!std::is_same_v<T, bool>) has_value = !value.empty();
      if (has_value) cell = value;
    }
    set(table, row, head, std::move(cell));
  }

  /// Leaves a cell empty; its column is then in the place of its description.
  template <class T>
  void set_none(Table& table, std::size_t row, Column head, const std::string& stored) const {
    head.unit = find_shown_unit(stored, units_, dimension_).name;
    head.counts = std::is_integral_v<T> && !std::is_same_v<T, bool>;
    set(table, row, head, {});
  }

  /// Returns the tables without empty columns and empty tables.
  std::deque<Table> take() {
    for (Table& table : tables_)
      std::erase_if(table.columns, [](const Column& column) {
        return std::all_of(column.cells.begin(), column.cells.end(),
                           [](const Cell& cell) { return std::holds_alternative<std::monostate>(cell); });
      });
    std::erase_if(tables_, [](const Table& table) { return table.columns.empty(); });
    return std::move(tables_);
  }

 private:
  ShownUnits units_;
  std::size_t dimension_;
  std::deque<Table> tables_;
  std::map<std::string, Table*> by_name_;
};

/// Returns the name of a component of a point or of another short list, counted from 0.
inline std::string name_component(std::size_t i, const std::string& unit) {
  const bool is_place = unit == "m" || unit == "kg m/s";
  return is_place && i < 3 ? std::string(1, "xyz"[i]) : std::to_string(i + 1);
}

/// Returns true for the coordinates of a point or vector, which are cells of one row and not rows.
inline bool is_point(const std::vector<double>& list, const std::string& unit) {
  return (unit == "m" || unit == "kg m/s") && (list.size() == 2 || list.size() == 3);
}

/// Writes one struct into a row of a table, and its lists into tables of their own.
class RowWriter {
 public:
  /// The row that a struct and the structs within it share, with title and key of its list.
  struct Row {
    Table& table;
    std::size_t number = 0;
    std::vector<Lead> leads;  ///< of the row itself
    std::string list_title, list_key;
    std::vector<Lead> identity;  ///< its first value, for tables of its lists
  };

  RowWriter(TableSet& set, Row& row, std::string path = "", std::string title = "", bool is_columnar = false)
      : set_(set), row_(row), path_(std::move(path)), title_(std::move(title)), is_columnar_(is_columnar) {}

  template <class T>
  void key(const char* name, const T& member, const About& about) {
    write(path_.empty() ? name : path_ + "." + name, title_.empty() ? about.title : title_ + ": " + about.title,
          about.unit, member);
  }
  template <class T>
  void maybe(const char* name, const std::optional<T>& member, const About& about) {
    key(name, member, about);
  }
  void derived(const char* name, const auto& value, const About& about) { key(name, value, about); }
  template <class T>
  void merge(const char* /*sign*/, const std::optional<T>& block) {
    if (block) describe(*this, *block);
  }

 private:
  template <class T>
  void write(const std::string& path, const std::string& title, const std::string& unit, const T& value) {
    if constexpr (is_optional<T>) {
      using Inner = typename T::value_type;
      if (value)
        write(path, title, unit, *value);
      else if constexpr (is_plain<Inner>)
        set_.set_none<Inner>(row_.table, row_.number, make_head(path, title, ""), unit);
    } else if constexpr (is_plain<T>) {
      set_plain(path, title, unit, value);
    } else if constexpr (is_array<T>) {
      for (std::size_t i = 0; i < value.size(); ++i)
        set_plain(path + "." + name_component(i, unit), title + " " + name_component(i, unit), unit, value[i]);
    } else if constexpr (is_struct<T>) {
      write_struct(path, title, value);
    } else {
      write_list(path, title, unit, value);
    }
  }

  Column make_head(const std::string& path, const std::string& title, const std::string& unit) const {
    return {path, title, unit, false, false, {}};
  }

  void set_plain(const std::string& path, const std::string& title, const std::string& unit, const auto& value) {
    set_.set_value(row_.table, row_.number, make_head(path, title, ""), unit, value);
    if (!row_.identity.empty() || row_.table.is_single) return;
    for (const Column& column : row_.table.columns)
      if (column.key == path) {
        Column head = make_head(row_.list_key + "." + path, row_.list_title + ": " + title, column.unit);
        head.counts = column.counts;
        row_.identity.push_back({head, column.cells[row_.number]});
      }
  }

  template <class T>
  void write_struct(const std::string& path, const std::string& title, const T& value) {
    if constexpr (!is_left_out<T>) {
      if (!has_columns<T> && row_.table.name.empty() && path_.empty()) {
        Table& own = set_.find(path, title);
        own.is_single = true;
        own.is_head = is_in_head<T>;
        Row row{own, set_.add_row(own, {}), {}, title, path, {}};
        RowWriter inner(set_, row);
        describe(inner, value);
      } else {
        RowWriter inner(set_, row_, path, title, has_columns<T>);
        describe(inner, value);
      }
    }
  }

  template <class T>
  void write_list(const std::string& path, const std::string& title, const std::string& unit, const T& value) {
    if constexpr (is_vector<T>) {
      using Entry = typename T::value_type;
      if constexpr (is_left_out<Entry>) return;
      if (value.empty()) return;
      if constexpr (is_entry<Entry>)
        if (is_columnar_ && !path_.empty()) return write_column(path, title, unit, value);
      if constexpr (std::is_same_v<T, std::vector<double>>)
        if (is_columnar_ && path_.empty() && (!has_list_ || value.size() == length_)) {
          length_ = value.size();
          return write_column(path, title, unit, value);
        }
      if constexpr (std::is_same_v<Entry, std::string> || std::is_enum_v<Entry>) {
        std::string joined;
        for (const Entry& entry : value) joined += (joined.empty() ? "" : "; ") + make_text(entry);
        return set_plain(path, title, unit, joined);
      } else if constexpr (std::is_same_v<T, std::vector<double>>) {
        if (is_point(value, unit)) {
          for (std::size_t i = 0; i < value.size(); ++i)
            set_plain(path + "." + name_component(i, unit), title + " " + name_component(i, unit), unit, value[i]);
          return;
        }
      }
    }
    Table& table = find_below(path, title);
    fill(table, list_leads(), title, path.substr(path.rfind('.') + 1), unit, value, 0);
  }

  static std::string make_text(const std::string& text) { return text; }
  template <class E>
  requires std::is_enum_v<E>
  static std::string make_text(E value) { return to_word(value); }

  Table& find_below(const std::string& path, const std::string& title) {
    const Table& above = row_.table;
    return set_.find(above.name.empty() ? path : above.name + "." + path,
                     above.name.empty() ? title : above.title + ": " + title);
  }

  /// Returns the columns that identify this row in the tables of its lists.
  std::vector<Lead> list_leads() const {
    std::vector<Lead> leads = row_.leads;
    if (row_.table.is_single) return leads;
    leads.push_back(make_number());
    leads.insert(leads.end(), row_.identity.begin(), row_.identity.end());
    return leads;
  }

  /// Returns the number of this row, counted from 1.
  Lead make_number() const {
    return {{row_.list_key + ".no", row_.list_title + ": no.", "", true, false, {}},
            static_cast<double>(row_.number + 1)};
  }

  /// Writes a list as a column of the table of its struct.
  template <class T>
  void write_column(const std::string& path, const std::string& title, const std::string& unit, const T& list) {
    const bool is_own = path_.empty();
    Table& table = is_own ? find_below("along", "along its length") : find_below(path_, title_);
    if (!has_list_) first_ = table.rows;
    has_list_ = true;
    while (table.rows < first_ + list.size()) set_.add_row(table, list_leads());
    const std::string key = is_own ? path : path.substr(path_.size() + 1),
                      name = is_own ? title : title.substr(title_.size() + 2);
    for (std::size_t i = 0; i < list.size(); ++i) set_entry(table, first_ + i, key, name, unit, list[i]);
  }

  /// Sets the cells of a value that is no struct.
  template <class T>
  void set_entry(Table& table, std::size_t row, const std::string& key, const std::string& title,
                 const std::string& unit, const T& value) {
    if constexpr (is_optional<T>) {
      if (value) set_entry(table, row, key, title, unit, *value);
    } else if constexpr (is_array<T> || is_vector<T>) {
      for (std::size_t i = 0; i < value.size(); ++i)
        set_.set_value(table, row,
                       make_head(key + "." + name_component(i, unit), title + " " + name_component(i, unit), ""), unit,
                       value[i]);
    } else {
      set_.set_value(table, row, make_head(key, title, ""), unit, value);
    }
  }

  /// Adds the rows of a list; of nested lists and maps one row for each innermost entry.
  template <class T>
  void fill(Table& table, const std::vector<Lead>& leads, const std::string& title, const std::string& key,
            const std::string& unit, const T& value, int depth) {
    if constexpr (is_map<T>) {
      for (const auto& [name, entry] : value) {
        std::vector<Lead> more = leads;
        const std::string head = depth == 0 ? "name" : "name " + std::to_string(depth + 1);
        more.push_back({{head, head, "", false, false, {}}, name});
        fill(table, more, title, key, unit, entry, depth + 1);
      }
    } else if constexpr (std::is_same_v<T, std::vector<double>>) {
      if (is_point(value, unit))
        set_entry(table, set_.add_row(table, leads), key, title, unit, value);
      else
        for (const double entry : value) set_entry(table, set_.add_row(table, leads), key, title, unit, entry);
    } else if constexpr (is_vector<T>) {
      using Entry = typename T::value_type;
      for (std::size_t i = 0; i < value.size(); ++i) {
        if constexpr (is_vector<Entry> || is_map<Entry>) {
          std::vector<Lead> more = leads;
          bool counts = true;
          if constexpr (std::is_same_v<Entry, std::vector<double>>) counts = !is_point(value[i], unit);
          if (counts) {
            const std::string head = "no" + (depth == 0 ? "" : " " + std::to_string(depth + 1));
            more.push_back({{head, head + ".", "", true, false, {}}, static_cast<double>(i + 1)});
          }
          fill(table, more, title, key, unit, value[i], depth + 1);
        } else {
          fill(table, leads, title, key, unit, value[i], depth + 1);
        }
      }
    } else if constexpr (is_struct<T>) {
      if constexpr (!is_left_out<T>) {
        table.is_head = is_in_head<T>;
        Row row{table, set_.add_row(table, leads), leads, title, key, {}};
        RowWriter inner(set_, row, "", "", has_own_columns<T>);
        describe(inner, value);
      }
    } else {
      set_entry(table, set_.add_row(table, leads), key, title, unit, value);
    }
  }

  TableSet& set_;
  Row& row_;
  std::string path_, title_;  ///< of the struct within its row
  bool is_columnar_;
  bool has_list_ = false;
  std::size_t first_ = 0, length_ = 0;  ///< first row and length of its lists
};

/// Returns the tables of a described struct.
template <class T>
std::deque<Table> visit_tables(const T& result, const ShownUnits& units, std::size_t dimension) {
  TableSet set(units, dimension);
  Table& own = set.find("", "");
  own.is_single = true;
  own.is_head = true;
  RowWriter::Row row{own, set.add_row(own, {}), {}, "", "", {}};
  RowWriter writer(set, row);
  describe(writer, result);
  return set.take();
}

}  // namespace talus::results
