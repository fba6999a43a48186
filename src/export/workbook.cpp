// SPDX-License-Identifier: MIT
#include "export/workbook.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <map>
#include <set>

#include "base/atomic_file.hpp"
#include "base/error.hpp"
#include "base/foreign_code.hpp"
#include "base/numbers.hpp"
#include "base/text.hpp"
#include "base/user_file.hpp"
#include "input/echo.hpp"
#include "output/files/history.hpp"

namespace talus::exports {
namespace {

namespace fs = std::filesystem;
using results::Cell;
using results::Table;

/// Names of sheets: unique regardless of case, without the characters and words that spreadsheets reserve.
class SheetNames {
 public:
  std::string take(const std::string& wanted) {
    std::string name;
    for (const char c : make_printable(wanted))
      name += std::string_view("[]:*?/\\'").find(c) == std::string_view::npos ? c : ' ';
    if (name.empty() || to_lower(name) == "history") name += " table";
    // The end of a path distinguishes it.
    if (name.size() > longest_sheet_name) {
      const std::size_t dot = name.find('.', name.size() - longest_sheet_name);
      name = dot == std::string::npos ? shorten(name) : name.substr(dot + 1);
    }
    const std::string stem = name;
    for (int i = 2; !taken_.insert(to_lower(name)).second; ++i) {
      const std::string number = fmt::format(" {}", i);
      name = shorten(stem, number.size()) + number;
    }
    return name;
  }

 private:
  static std::string shorten(std::string name, std::size_t reserve = 0) {
    name.resize(std::min(name.size(), longest_sheet_name - reserve));
    while (find_wrong_utf8(name)) name.pop_back();
    return name;
  }

  std::set<std::string> taken_;
};

/// Returns a text that every spreadsheet can read.
std::string clean_cell(const std::string& text) {
  std::string clean = make_printable(text, true);
  if (clean.size() <= longest_cell) return clean;
  clean.resize(longest_cell);
  while (find_wrong_utf8(clean)) clean.pop_back();
  return clean + " … (cut off)";
}

Table make_list(const std::string& title, const std::vector<std::string>& columns) {
  Table table;
  table.title = title;
  for (const std::string& column : columns) table.columns.push_back({column, column, "", false, false, {}});
  return table;
}

void add_row(Table& table, std::vector<Cell> cells) {
  for (std::size_t i = 0; i < table.columns.size(); ++i) table.columns[i].cells.push_back(std::move(cells[i]));
  ++table.rows;
}

/// Returns the single row of a table as a list of quantities.
Table turn(const Table& table) {
  Table turned = make_list(table.title, {"quantity", "value", "unit"});
  turned.name = table.name;
  turned.is_head = table.is_head;
  turned.is_single = true;
  turned.columns[1].is_mixed = true;
  for (const results::Column& column : table.columns)
    add_row(turned, {column.title, column.cells.front(), column.unit.empty() ? Cell() : Cell(column.unit)});
  return turned;
}

/// Every key of the case.
Table make_input_table(const JsonTree& echo) {
  Table table = make_list("Input", {"key", "value", "unit", "given"});
  table.columns[1].is_mixed = true;
  for (const input::ListedKey& key : input::list_keys(echo))
    add_row(table, {key.path,
                    key.number         ? Cell(*key.number)
                    : key.text.empty() ? Cell()
                                       : Cell(key.text),
                    key.unit.empty() ? Cell() : Cell(key.unit), key.is_given});
  return table;
}

/// Warnings, errors and remarks, each sentence once.
class Warnings {
 public:
  void add(const std::string& from, const std::string& sentence) {
    if (!sentence.empty() && known_.insert(sentence).second) add_row(table_, {from, sentence});
  }
  void add(const std::string& from, const std::vector<std::string>& sentences) {
    for (const std::string& sentence : sentences) add(from, sentence);
  }
  Table take() { return std::move(table_); }

 private:
  Table table_ = make_list("Warnings", {"from", "sentence"});
  std::set<std::string> known_;
};

Warnings list_warnings(const report::ResultFolder& folder) {
  const results::RunResult& run = folder.run;
  Warnings list;
  list.add("run", run.error.value_or(""));
  list.add("run", run.warnings);
  const auto add = [&](Method method, const auto& result) {
    if (!result) return;
    list.add(get_title(method), result->error.value_or(""));
    list.add(get_title(method), result->warnings);
  };
  add(Method::lem, run.slices);
  add(Method::fem, run.elements);
  add(Method::bounds, run.bounds);
  add(Method::seepage, run.flow);
  if (run.elements)
    for (const results::ElementRun& one : run.elements->runs) list.add(get_title(Method::fem), one.warnings);
  if (run.slices)
    for (const auto* surfaces : {&run.slices->critical, &run.slices->noncircular, &run.slices->given})
      for (const results::CriticalSurface& surface : *surfaces) list.add(surface.surface.title, surface.warnings);
  if (run.methods) {
    list.add("comparison", run.methods->warnings);
    for (const results::Remark& remark : run.methods->remarks) list.add("remark", remark.text);
  }
  if (run.timeline) list.add("timeline", run.timeline->notes);
  if (folder.study_result) list.add("study", folder.study_result->notes);
  if (folder.calibration) list.add("calibration", folder.calibration->findings);
  return list;
}

/// A result under its name in [[compare]], in its unit of display.
Table make_named_table(const std::vector<results::NamedResult>& named) {
  Table table = make_list("results by name", {"name", "title", "value", "unit"});
  table.columns[2].is_mixed = true;
  for (const results::NamedResult& result : named)
    add_row(table, {result.name, result.title,
                    result.undetermined                            ? Cell(*result.undetermined)
                    : result.value && std::isfinite(*result.value) ? Cell(*result.value / result.unit.si)
                                                                   : Cell(),
                    result.unit.name});
  return table;
}

Table make_history_table(const fs::path& file, const fs::path& folder) {
  const output::HistoryTable history = output::read_history(file);
  Table table;
  table.name = fs::relative(file, folder).string();
  table.title = table.name;
  for (std::size_t c = 0; c < history.columns.size(); ++c) {
    results::Column column{history.columns[c].name, history.columns[c].name, history.columns[c].unit, false, false, {}};
    for (const double value : history.values[c]) column.cells.push_back(std::isfinite(value) ? Cell(value) : Cell());
    table.rows = std::max(table.rows, column.cells.size());
    table.columns.push_back(std::move(column));
  }
  for (results::Column& column : table.columns) column.cells.resize(table.rows);
  return table;
}

/// Returns the histories of a folder that a run wrote, in the order of their names.
std::vector<fs::path> list_histories(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const char* name :
       {"history.csv", "monitors.csv", "profile.csv", "season.csv", "curve.csv", "construction_monitors.csv"})
    if (fs::is_regular_file(folder / name)) files.push_back(folder / name);
  if (fs::is_directory(folder / "sections")) {
    const std::size_t first = files.size();
    for (const auto& entry : fs::directory_iterator(folder / "sections"))
      if (entry.is_regular_file() && entry.path().extension() == ".csv") files.push_back(entry.path());
    std::sort(files.begin() + static_cast<std::ptrdiff_t>(first), files.end());
  }
  return files;
}

class WorkbookMaker {
 public:
  explicit WorkbookMaker(const report::ResultFolder& folder) : folder_(folder) {}

  Workbook make() {
    names_.take("Summary");
    names_.take("Input");
    names_.take("Warnings");
    const results::RunResult& run = folder_.run;
    if (folder_.study_result)
      add_result(results::make_value(*folder_.study_result), make_units(*folder_.study_result),
                 !folder_.study_result->columns.empty());
    if (folder_.has_tests_alone)
      add_result(results::make_value(*folder_.tests), read_units(run));
    else if (!folder_.is_study())
      add_result(results::make_value(run), read_units(run));
    if (folder_.calibration) add_result(results::make_value(*folder_.calibration), ShownUnits{});
    if (!run.results.empty()) summary_.push_back(make_named_table(run.results));
    for (const fs::path& file : list_histories(folder_.path)) add_history(file);
    JsonTree input = run.input;
    if (input.is_empty() && folder_.study_result && folder_.study_result->input) input = *folder_.study_result->input;
    finish(input);
    return std::move(book_);
  }

 private:
  static ShownUnits make_units(const results::StudyResult& study) {
    return make_shown_units(study.units.length, study.units.displacement, study.units.stress.value_or("kPa"));
  }

  void add_result(results::Value result, const ShownUnits& units, bool has_study_table = false) {
    if (has_study_table) add_sheet(results::make_study_table(*folder_.study_result));
    for (Table& table : results::make_tables(result, units, report::get_dimension(folder_.run))) {
      if (table.is_single) table = turn(table);
      if (table.is_head)
        summary_.push_back(std::move(table));
      else
        add_sheet(std::move(table));
    }
  }

  void add_sheet(Table table) {
    if (table.rows + 1 > most_sheet_rows) {
      book_.remarks.push_back(
          fmt::format("'{}' has {} rows, more than a sheet, and is left out", table.name, table.rows));
      return;
    }
    Sheet& sheet = book_.sheets.emplace_back();
    sheet.name = names_.take(table.name);
    sheet.tables.push_back(std::move(table));
  }

  void add_history(const fs::path& file) {
    Table table = make_history_table(file, folder_.path);
    if (table.rows > 0) add_sheet(std::move(table));
  }

  void finish(const JsonTree& input) {
    const results::RunResult& run = folder_.run;
    book_.title = folder_.study_result ? folder_.study_result->title : run.title;
    book_.author = run.project.author;
    book_.program = fmt::format("{} {}", run.provenance.program, run.provenance.version);
    Warnings warnings = list_warnings(folder_);
    warnings.add("export", book_.remarks);
    Sheet input_sheet{"Input", {make_input_table(input)}, false}, warning_sheet{"Warnings", {warnings.take()}, false};
    for (Sheet* sheet : {&input_sheet, &warning_sheet})
      if (sheet->tables.front().rows > 0) book_.sheets.push_back(std::move(*sheet));
    // After the head of the results come their factors, then the title block and the program.
    std::stable_sort(summary_.begin() + 1, summary_.end(),
                     [](const Table& a, const Table& b) { return !a.is_single && b.is_single; });
    Table contents = make_list("sheets", {"sheet", "contents"});
    for (const Sheet& sheet : book_.sheets) add_row(contents, {sheet.name, sheet.tables.front().title});
    summary_.push_back(std::move(contents));
    book_.sheets.insert(book_.sheets.begin(), Sheet{"Summary", std::move(summary_), true});
    for (Sheet& sheet : book_.sheets)
      for (Table& table : sheet.tables)
        for (results::Column& column : table.columns) {
          column.title = clean_cell(column.title);
          for (Cell& cell : column.cells)
            if (auto* text = std::get_if<std::string>(&cell)) *text = clean_cell(*text);
        }
  }

  const report::ResultFolder& folder_;
  SheetNames names_;
  std::deque<Table> summary_;
  Workbook book_;
};

}  // namespace

Workbook make_workbook(const report::ResultFolder& folder) {
  return WorkbookMaker(folder).make();
}

void write_workbook(const Workbook& workbook, const fs::path& path) {
  std::string why, error;
  void* write = load_module("libtalus_xlsx.so", "talus_write_workbook", false, why);
  if (write == nullptr)
    fail_input(
        "this build of the program cannot write workbooks, because it has no libxlsxwriter ({}); 'make program "
        "CMAKE_ARGS=-DTALUS_XLSX=ON' in its source folder adds it",
        why);
  if (const fs::path folder = path.parent_path(); !folder.empty() && !fs::is_directory(folder))
    throw_cannot_write(path, ENOENT);
  const PlainNumbers plain;  // libxlsxwriter prints numbers with the decimal sign of the locale
  const fs::path temporary = begin_file(path);
  reinterpret_cast<WriteByXlsxWriter>(write)(workbook, temporary.c_str(), error);
  if (!error.empty()) {
    clear_temporary(path);
    throw Error(ExitCode::cannot_write, "cannot write '{}': {}", path.string(), error);
  }
  publish(path);
}

}  // namespace talus::exports
