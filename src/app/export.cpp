// SPDX-License-Identifier: MIT
// `talus export RESULTS`: the section of results or of a case as DXF, or the tables of results as a workbook.

#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "app/command_line.hpp"
#include "base/error.hpp"
#include "base/file_list.hpp"
#include "base/folder_lock.hpp"
#include "base/text.hpp"
#include "export/section.hpp"
#include "export/workbook.hpp"
#include "input/read.hpp"

namespace talus::app {
namespace {

namespace fs = std::filesystem;

struct ExportOptions {
  std::string source, units;
  fs::path output;
  bool overwrite = false;
};

void print_result(const ExportOptions& options, const std::vector<std::string>& remarks) {
  std::string text = fmt::format("{} is written\n", options.output.string());
  for (const std::string& remark : remarks) text += "  " + remark + "\n";
  print(stdout, text);
}

void write_section(const ExportOptions& options, const exports::SectionDrawing& section) {
  drawing::write_drawing(section.drawing, options.output);
  print_result(options, section.remarks);
}

void export_case(const ExportOptions& options, bool as_workbook) {
  if (as_workbook)
    fail_input("'{}' is a case, which has no results yet: a workbook needs the folder of a run's results",
               options.source);
  const input::LoadedCase loaded = input::read_case(options.source);
  write_section(options, exports::draw_case(loaded.data, options.source, options.units));
}

void export_folder(const ExportOptions& options, bool as_workbook) {
  const ResultsLock lock(options.source);
  const report::ResultFolder folder = report::open_folder(options.source);
  const auto files = FileList::find(options.output);
  if (!as_workbook) return write_section(options, exports::draw_run(folder, options.units));
  const exports::Workbook workbook = exports::make_workbook(folder);
  exports::write_workbook(workbook, options.output);
  print_result(options, workbook.remarks);
}

void export_results(const ExportOptions& options) {
  const std::string ending = to_lower(options.output.extension().string());
  if (ending != ".dxf" && ending != ".xlsx")
    fail_input("'{}' does not end in .dxf (section) or .xlsx (tables), the files that can be written",
               options.output.string());
  const bool as_workbook = ending == ".xlsx";
  if (as_workbook && !options.units.empty())
    fail_input("--units is the unit of length of a DXF; a workbook has the units of [output] of the case");
  if (!options.overwrite && fs::exists(options.output))
    fail_input("'{}' exists; give another name with -o, or --overwrite", options.output.string());
  if (fs::is_regular_file(options.source))
    export_case(options, as_workbook);
  else if (fs::is_directory(options.source))
    export_folder(options, as_workbook);
  else
    fail_input("there is no folder of results{} '{}'", as_workbook ? "" : " and no case file", options.source);
}

}  // namespace

void add_export(CLI::App& app) {
  const Command command(app, "export",
                        "Write the section of results or of a case as DXF, or the tables of results as XLSX");
  const auto options = std::make_shared<ExportOptions>();
  command.take("RESULTS", options->source, "Folder of the results; or a case file, for its section alone").required();
  command.take("-o,--output", options->output, "File to write; its ending, .dxf or .xlsx, sets the format")
      .required()
      .shown_as("FILE");
  command.take("--units", options->units, "Unit of length of the DXF; by default that of the results").shown_as("UNIT");
  command.flag("--overwrite", options->overwrite, "Replace the file");
  command.act([options] { export_results(*options); });
}

}  // namespace talus::app
