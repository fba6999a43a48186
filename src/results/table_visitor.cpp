// SPDX-License-Identifier: MIT
#include "results/table_visitor.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace talus::results {
namespace {

/// Returns true for entries of lists that are cells of one row.
bool is_entry(const Type& type) {
  if (type.shape == Shape::optional || type.shape == Shape::array) return type.inner->is_plain();
  return type.is_plain();
}
bool is_struct(const Type& type) {
  return type.shape == Shape::structure || type.shape == Shape::tree;
}
bool is_number_list(const Type& type) {
  return type.shape == Shape::list && type.inner->shape == Shape::number;
}

/// A value of the rows above a list, repeated in each of its rows.
struct Lead {
  Column head;
  Cell cell;
};

Cell make_integer_cell(Value value) {
  constexpr std::int64_t most = std::int64_t{1} << 53;  // larger ones are no doubles
  const std::int64_t bits = value.get_integer();
  if (value.type->is_signed) {
    if (-most <= bits && bits <= most) return static_cast<double>(bits);
    return std::to_string(bits);
  }
  const auto number = static_cast<std::uint64_t>(bits);
  if (number <= static_cast<std::uint64_t>(most)) return static_cast<double>(number);
  return std::to_string(number);
}

/// Returns the cell of a plain value, in a unit of `si`.
Cell make_cell(Value value, double si) {
  switch (value.shape()) {
    case Shape::word:
      return std::string(value.get_word());
    case Shape::integer:
      return make_integer_cell(value);
    case Shape::boolean:
      return value.get_boolean();
    case Shape::number:
      if (std::isfinite(value.get_number())) return value.get_number() / si;
      return {};
    default:
      if (!value.get_text().empty()) return value.get_text();
      return {};
  }
}

/// The tables of one result, by name.
class TableSet {
 public:
  TableSet(const TableRules& all_rules, const ShownUnits& units, std::size_t dimension)
      : rules(all_rules), units_(units), dimension_(dimension) {}

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

  /// Sets the cell of a plain value, which has its column even where the value is left out.
  void set_value(Table& table, std::size_t row, Column head, const std::string& stored, Value value) const {
    const ShownUnit unit = find_shown_unit(stored, units_, dimension_);
    head.unit = unit.name;
    head.counts = value.shape() == Shape::integer;
    set(table, row, head, value.is_null() ? Cell() : make_cell(value, unit.si));
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

  const TableRules& rules;

 private:
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

  ShownUnits units_;
  std::size_t dimension_;
  std::deque<Table> tables_;
  std::map<std::string, Table*> by_name_;
};

/// Returns the name of a component of a point or of another short list, counted from 0.
std::string name_component(std::size_t i, const std::string& unit) {
  const bool is_place = unit == "m" || unit == "kg m/s";
  return is_place && i < 3 ? std::string(1, "xyz"[i]) : std::to_string(i + 1);
}

/// Returns true for the coordinates of a point or vector, which are cells of one row and not rows.
bool is_point(Value list, const std::string& unit) {
  const std::size_t size = list.get_size();
  return is_number_list(*list.type) && (unit == "m" || unit == "kg m/s") && (size == 2 || size == 3);
}

Column make_head(const std::string& key, const std::string& title, const std::string& unit = "") {
  return {key, title, unit, false, false, {}};
}

/// Writes one struct into a row of a table, and its lists into tables of their own.
class RowWriter : public Visitor {
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

 protected:
  void visit(const Key& key, Value value) override {
    write(path_.empty() ? key.name : path_ + "." + key.name,
          title_.empty() ? key.about.title : title_ + ": " + key.about.title, key.about.unit, value);
  }
  void visit_merged(const char* /*sign*/, Value block) override {
    if (const Value held = block.get_held(); !held.is_null()) held.describe(*this);
  }

 private:
  void write(const std::string& path, const std::string& title, const std::string& unit, Value value) {
    if (value.shape() == Shape::optional) {
      const Value held = value.get_held();
      if (!held.is_null())
        write(path, title, unit, held);
      else if (held.type->is_plain())
        set_.set_value(row_.table, row_.number, make_head(path, title), unit, held);
    } else if (value.type->is_plain()) {
      set_plain(path, title, unit, value);
    } else if (value.shape() == Shape::array) {
      set_components(path, title, unit, value);
    } else if (is_struct(*value.type)) {
      write_struct(path, title, value);
    } else {
      write_list(path, title, unit, value);
    }
  }

  void set_plain(const std::string& path, const std::string& title, const std::string& unit, Value value) {
    set_.set_value(row_.table, row_.number, make_head(path, title), unit, value);
    if (!row_.identity.empty() || row_.table.is_single) return;
    for (const Column& column : row_.table.columns)
      if (column.key == path) {
        Column head = make_head(row_.list_key + "." + path, row_.list_title + ": " + title, column.unit);
        head.counts = column.counts;
        row_.identity.push_back({head, column.cells[row_.number]});
      }
  }

  void set_components(const std::string& path, const std::string& title, const std::string& unit, Value list) {
    for (std::size_t i = 0; i < list.get_size(); ++i)
      set_plain(path + "." + name_component(i, unit), title + " " + name_component(i, unit), unit, list.get_entry(i));
  }

  void write_struct(const std::string& path, const std::string& title, Value value) {
    const Type* type = value.type;
    if (set_.rules.left_out.contains(type)) return;
    const bool has_columns = set_.rules.columns.contains(type);
    if (!has_columns && row_.table.name.empty() && path_.empty()) {
      Table& own = set_.find(path, title);
      own.is_single = true;
      own.is_head = set_.rules.in_head.contains(type);
      Row row{own, set_.add_row(own, {}), {}, title, path, {}};
      RowWriter inner(set_, row);
      value.describe(inner);
    } else {
      RowWriter inner(set_, row_, path, title, has_columns);
      value.describe(inner);
    }
  }

  /// Returns true if a list is a column of the table of its struct.
  bool is_column(Value list) {
    if (!is_columnar_) return false;
    if (!path_.empty()) return is_entry(*list.type->inner);
    if (!is_number_list(*list.type) || (has_list_ && list.get_size() != length_)) return false;
    length_ = list.get_size();
    return true;
  }

  void write_list(const std::string& path, const std::string& title, const std::string& unit, Value value) {
    if (value.shape() == Shape::list) {
      const Type& entry = *value.type->inner;
      if (set_.rules.left_out.contains(&entry) || value.get_size() == 0) return;
      if (is_column(value)) return write_column(path, title, unit, value);
      if (entry.shape == Shape::text || entry.shape == Shape::word) {
        const std::string joined = join(value);
        return set_plain(path, title, unit, make_value(joined));
      }
      if (is_point(value, unit)) return set_components(path, title, unit, value);
    }
    Table& table = find_below(path, title);
    fill(table, list_leads(), title, path.substr(path.rfind('.') + 1), unit, value, 0);
  }

  static std::string join(Value list) {
    std::string joined;
    for (std::size_t i = 0; i < list.get_size(); ++i) {
      const Value entry = list.get_entry(i);
      joined += (joined.empty() ? "" : "; ") + (entry.shape() == Shape::word ? entry.get_word() : entry.get_text());
    }
    return joined;
  }

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
  void write_column(const std::string& path, const std::string& title, const std::string& unit, Value list) {
    const bool is_own = path_.empty();
    Table& table = is_own ? find_below("along", "along its length") : find_below(path_, title_);
    if (!has_list_) first_ = table.rows;
    has_list_ = true;
    while (table.rows < first_ + list.get_size()) set_.add_row(table, list_leads());
    const std::string key = is_own ? path : path.substr(path_.size() + 1),
                      name = is_own ? title : title.substr(title_.size() + 2);
    for (std::size_t i = 0; i < list.get_size(); ++i) set_entry(table, first_ + i, key, name, unit, list.get_entry(i));
  }

  /// Sets the cells of a value that is no struct.
  void set_entry(Table& table, std::size_t row, const std::string& key, const std::string& title,
                 const std::string& unit, Value value) {
    if (value.shape() == Shape::optional) {
      if (const Value held = value.get_held(); !held.is_null()) set_entry(table, row, key, title, unit, held);
    } else if (value.shape() == Shape::array || value.shape() == Shape::list) {
      for (std::size_t i = 0; i < value.get_size(); ++i)
        set_.set_value(table, row,
                       make_head(key + "." + name_component(i, unit), title + " " + name_component(i, unit)), unit,
                       value.get_entry(i));
    } else {
      set_.set_value(table, row, make_head(key, title), unit, value);
    }
  }

  /// Adds the rows of a list; of nested lists and maps one row for each innermost entry.
  void fill(Table& table, const std::vector<Lead>& leads, const std::string& title, const std::string& key,
            const std::string& unit, Value value, int depth) {
    if (value.shape() == Shape::map) {
      value.type->for_each(value.at, [&](const std::string& name, void* entry) {
        std::vector<Lead> more = leads;
        const std::string head = depth == 0 ? "name" : "name " + std::to_string(depth + 1);
        more.push_back({make_head(head, head), name});
        fill(table, more, title, key, unit, {entry, value.type->inner}, depth + 1);
      });
    } else if (value.shape() == Shape::list && !is_point(value, unit)) {
      for (std::size_t i = 0; i < value.get_size(); ++i) {
        const Value entry = value.get_entry(i);
        if (is_counted(entry, unit))
          fill(table, number_entry(leads, i, depth), title, key, unit, entry, depth + 1);
        else
          fill(table, leads, title, key, unit, entry, depth + 1);
      }
    } else if (is_struct(*value.type)) {
      if (set_.rules.left_out.contains(value.type)) return;
      table.is_head = set_.rules.in_head.contains(value.type);
      Row row{table, set_.add_row(table, leads), leads, title, key, {}};
      RowWriter inner(set_, row, "", "", set_.rules.own_columns.contains(value.type));
      value.describe(inner);
    } else {
      set_entry(table, set_.add_row(table, leads), key, title, unit, value);
    }
  }

  /// Returns true for an entry that is a list itself, so that its number is a column.
  static bool is_counted(Value entry, const std::string& unit) {
    if (entry.shape() == Shape::list) return !is_point(entry, unit);
    return entry.shape() == Shape::map;
  }

  static std::vector<Lead> number_entry(std::vector<Lead> leads, std::size_t i, int depth) {
    const std::string head = "no" + (depth == 0 ? "" : " " + std::to_string(depth + 1));
    leads.push_back({{head, head + ".", "", true, false, {}}, static_cast<double>(i + 1)});
    return leads;
  }

  TableSet& set_;
  Row& row_;
  std::string path_, title_;  ///< of the struct within its row
  bool is_columnar_;
  bool has_list_ = false;
  std::size_t first_ = 0, length_ = 0;  ///< first row and length of its lists
};

}  // namespace

std::deque<Table> visit_tables(Value result, const TableRules& rules, const ShownUnits& units, std::size_t dimension) {
  TableSet set(rules, units, dimension);
  Table& own = set.find("", "");
  own.is_single = true;
  own.is_head = true;
  RowWriter::Row row{own, set.add_row(own, {}), {}, "", "", {}};
  RowWriter writer(set, row);
  result.describe(writer);
  return set.take();
}

}  // namespace talus::results
