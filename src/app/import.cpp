// SPDX-License-Identifier: MIT
// `talus import FILE`: the section of a drawing, or an analysis of GeoStudio, as a case file.

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <memory>

#include "app/command_line.hpp"
#include "base/atomic_file.hpp"
#include "base/error.hpp"
#include "base/numbers.hpp"
#include "base/text.hpp"
#include "base/units.hpp"
#include "drawing/geostudio.hpp"
#include "drawing/section.hpp"

namespace talus::app {
namespace {

struct ImportOptions {
  std::string file, units, role, base, analysis;
  std::filesystem::path output;
  std::vector<std::string> layers;
  bool overwrite = false;
};

double find_unit(const drawing::Drawing& drawing, const ImportOptions& options) {
  if (!options.units.empty()) return units::parse_as_si("1 " + options.units, "m", "--units");
  if (!drawing.unit)
    fail_input("'{}' does not state its unit of length ($INSUNITS): give --units, for example --units mm",
               options.file);
  return units::parse_as_si("1 " + *drawing.unit, "m", "the unit of the drawing");
}

/// Reads "-5" [m] or "-5 ft".
double read_level(const std::string& text) {
  if (const double plain = read_number(text); std::isfinite(plain)) return plain;
  return units::parse_as_si(text, "m", "--base");
}

drawing::ImportedCase import_drawing(const ImportOptions& options, const std::string& source) {
  const drawing::Drawing drawing = drawing::read_drawing(options.file);
  drawing::SectionOptions meaning{
      .unit = find_unit(drawing, options), .role = {}, .base = {}, .layers = options.layers};
  if (!options.role.empty())
    meaning.role = options.role == "tops" ? drawing::LineRole::tops : drawing::LineRole::bottoms;
  if (!options.base.empty()) meaning.base = read_level(options.base);
  drawing::DrawnSection section = drawing::find_section(drawing, meaning);
  section.remarks.push_back("strengths and weights are to be completed");
  return {drawing::write_case(section, source), std::move(section.remarks)};
}

void import_file(const ImportOptions& options) {
  if (!options.overwrite && std::filesystem::exists(options.output))
    fail_input("'{}' exists; give another name with -o, or --overwrite", options.output.string());
  const std::filesystem::path file = options.file;
  const std::string source = file.filename().string();
  const drawing::ImportedCase found =
      to_lower(file.extension().string()) == ".gsz"
          ? drawing::translate_model(drawing::read_model(options.file), options.analysis, source)
          : import_drawing(options, source);
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
      "Make a case file of a section from CAD or GIS (DXF, GeoPackage, GeoJSON) or of a GeoStudio file (.gsz)");
  const auto options = std::make_shared<ImportOptions>();
  command.take("file", options->file, "The drawing or GeoStudio file").required().shown_as("FILE");
  command.take("-o,--output", options->output, "Case file to write").required().shown_as("CASE");
  command.take("--units", options->units, "Unit of length of the drawing, if it states none or a wrong one")
      .shown_as("UNIT");
  command.take("--layers", options->layers, "Layer of the drawing to use; once for each").one_each().shown_as("NAME");
  command
      .take("--lines", options->role,
            "Lines are the bottoms or the tops of the soils of their layers (default: bottoms)")
      .one_of({"bottoms", "tops"});
  command.take("--base", options->base, "Level of the base of the section, below the lowest line [m]")
      .shown_as("LEVEL");
  command.flag("--overwrite", options->overwrite, "Replace the case file");
  command
      .take("--analysis", options->analysis,
            "Name of the SLOPE/W analysis in a GeoStudio file; by default the first one")
      .shown_as("NAME");
  command.act([options] { import_file(*options); });
}

}  // namespace talus::app
