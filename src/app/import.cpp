// SPDX-License-Identifier: MIT
// `talus import DRAWING`: the section of a drawing as a case file.

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
#include "drawing/section.hpp"

namespace talus::app {
namespace {

struct ImportOptions {
  std::string file, units, role, base;
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

void import_drawing(const ImportOptions& options) {
  if (!options.overwrite && std::filesystem::exists(options.output))
    fail_input("'{}' exists; give another name with -o, or --overwrite", options.output.string());
  const drawing::Drawing drawing = drawing::read_drawing(options.file);
  const double unit = find_unit(drawing, options);
  drawing::SectionOptions meaning{.unit = unit, .role = {}, .base = {}, .layers = options.layers};
  if (!options.role.empty())
    meaning.role = options.role == "tops" ? drawing::LineRole::tops : drawing::LineRole::bottoms;
  if (!options.base.empty()) meaning.base = read_level(options.base);
  const drawing::DrawnSection section = drawing::find_section(drawing, meaning);
  write_atomically(options.output,
                   drawing::write_case(section, std::filesystem::path(options.file).filename().string()));
  std::string text =
      fmt::format("{}: {} layer{}, {} closed region{}{}\n", options.output.string(), section.layers.size(),
                  section.layers.size() == 1 ? "" : "s", section.regions.size(), section.regions.size() == 1 ? "" : "s",
                  section.water_table.empty() ? "" : ", a water table");
  constexpr std::size_t most_remarks = 40;
  for (std::size_t i = 0; i < section.remarks.size() && i < most_remarks; ++i) text += "  " + section.remarks[i] + "\n";
  if (section.remarks.size() > most_remarks)
    text += fmt::format("  … and {} more\n", section.remarks.size() - most_remarks);
  print(stdout, text + "Complete the strengths of the soils, then: talus check " + options.output.string() + "\n");
}

}  // namespace

void add_import(CLI::App& app) {
  const Command command(app, "import", "Make a case file of a section drawn in CAD or GIS (DXF, GeoPackage, GeoJSON)");
  const auto options = std::make_shared<ImportOptions>();
  command.take("drawing", options->file, "The drawing").required().shown_as("DRAWING");
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
  command.act([options] { import_drawing(*options); });
}

}  // namespace talus::app
