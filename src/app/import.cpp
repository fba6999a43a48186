// SPDX-License-Identifier: MIT
// `talus import FILE`: the section of a survey or a drawing, or an analysis of GeoStudio, as a case file.

#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "app/command_line.hpp"
#include "base/atomic_file.hpp"
#include "base/error.hpp"
#include "base/text.hpp"
#include "drawing/import.hpp"

namespace talus::app {
namespace {

struct ImportCommand {
  drawing::ImportOptions from;
  std::filesystem::path output;
  bool overwrite = false;
};

void import_file(const ImportCommand& options) {
  if (!options.overwrite && std::filesystem::exists(options.output))
    fail_input("'{}' exists; give another name with -o, or --overwrite", options.output.string());
  const drawing::ImportedCase found = drawing::import_files(options.from);
  write_atomically(options.output, found.text);
  std::string text = fmt::format("{} is written\n", options.output.string());
  constexpr std::size_t most_remarks = 40;
  for (std::size_t i = 0; i < found.remarks.size() && i < most_remarks; ++i) text += "  " + found.remarks[i] + "\n";
  if (found.remarks.size() > most_remarks)
    text += fmt::format("  … and {} more\n", found.remarks.size() - most_remarks);
  print(stdout, text + "Next: talus check " + options.output.string() + "\n");
}

}  // namespace

void add_import(CLI::App& app) {
  const Command command(
      app, "import",
      "Make a case file of a section from tables of lines or boreholes (.csv, .ags), from CAD or GIS (DXF, GeoPackage, "
      "GeoJSON), or from a GeoStudio file (.gsz)");
  const auto options = std::make_shared<ImportCommand>();
  command
      .take(
          "files", options->from.files,
          "The drawing, the GeoStudio file, or tables: the ground and lower boundaries from the top down, or boreholes")
      .required()
      .shown_as("FILE");
  command.take("-o,--output", options->output, "Case file to write").required().shown_as("CASE");
  command
      .take("--units", options->from.units, "Unit of length of the drawing or table, if it states none or a wrong one")
      .shown_as("UNIT");
  command.take("--layers", options->from.layers, "Layer of the drawing to use; once for each")
      .one_each()
      .shown_as("NAME");
  command
      .take("--lines", options->from.role,
            "Lines are the bottoms or the tops of the soils of their layers (default: bottoms)")
      .one_of({"bottoms", "tops"});
  command
      .take("--as", options->from.form,
            "Write layers, or the regions that the lines of a drawing enclose (default: regions where lines cross)")
      .one_of({"layers", "regions"});
  command
      .take("--snap", options->from.snap,
            "Distance below which ends of lines meet others [m] (default: 1e-4 of the section)")
      .shown_as("LENGTH");
  command.take("--base", options->from.base, "Level of the base of the section, below the lowest line [m]")
      .shown_as("LEVEL");
  command
      .take("--boreholes", options->from.boreholes,
            "Borehole to use, of tables with more than those of the section; once for each")
      .one_each()
      .shown_as("NAME");
  command.flag("--overwrite", options->overwrite, "Replace the case file");
  command
      .take("--analysis", options->from.analysis,
            "Name of the SLOPE/W analysis in a GeoStudio file; by default the first one")
      .shown_as("NAME");
  command.act([options] { import_file(*options); });
}

}  // namespace talus::app
