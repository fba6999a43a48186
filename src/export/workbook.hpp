// SPDX-License-Identifier: MIT
#pragma once
// A folder of results as a workbook: sheets of tables, and its file, written by libxlsxwriter in the module
// libtalus_xlsx.so.

#include <deque>
#include <filesystem>
#include <string>
#include <vector>

#include "report/folder/result_folder.hpp"
#include "results/tables.hpp"

namespace talus::exports {

/// Limits of the file format.
inline constexpr std::size_t most_sheet_rows = 1'048'576, longest_sheet_name = 31, longest_cell = 32'000;

/// A sheet: one table, or several below one another.
struct Sheet {
  std::string name;  ///< unique, and allowed by spreadsheets
  std::deque<results::Table> tables;
  bool ends_with_links = false;  ///< the first column of the last table has names of sheets
};

struct Workbook {
  std::string title, author, program;  ///< properties of the file
  std::vector<Sheet> sheets;
  std::vector<std::string> remarks;  ///< files of the folder that are left out
};

/// Makes the workbook of a run, a study or element tests: `Summary` (program, case, factors, list of the sheets), one
/// sheet for each further table, `Input` and `Warnings`. Numbers are in units of display. Throws Error (wrong_input) if
/// a history of the folder is damaged.
Workbook make_workbook(const report::ResultFolder& folder);

/// Writes a workbook atomically. Texts remain texts, also those that begin with =. Throws Error (wrong_input) if this
/// build has no libxlsxwriter, and Error (cannot_write).
void write_workbook(const Workbook& workbook, const std::filesystem::path& path);

/// The function of the module: writes the file at `path` and returns an error text (empty: none).
using WriteByXlsxWriter = void (*)(const Workbook& workbook, const char* path, std::string& error);

}  // namespace talus::exports
