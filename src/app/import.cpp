// SPDX-License-Identifier: MIT
// `talus import FILE`: the section of a survey or a drawing, or an analysis of GeoStudio, as a case file.

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
#include "drawing/survey.hpp"

namespace talus::app {
namespace {

struct ImportOptions {
  std::vector<std::string> files;
  std::string units, role, form, base, snap, analysis;
  std::filesystem::path output;
  std::vector<std::string> layers;
  bool overwrite = false;
};

double find_unit(const drawing::Drawing& drawing, const ImportOptions& options) {
  if (!options.units.empty()) return units::parse_as_si("1 " + options.units, "m", "--units");
  if (!drawing.unit)
    fail_input("'{}' does not state its unit of length ($INSUNITS): give --units, for example --units mm",
               options.files.front());
  return units::parse_as_si("1 " + *drawing.unit, "m", "the unit of the drawing");
}

/// Reads "-5" [m] or "-5 ft".
double read_length(const std::string& text, const char* option) {
  const char* const end = text.data() + text.size();
  if (double plain = 0; parse_number(text.data(), end, plain) == end && std::isfinite(plain)) return plain;
  return units::parse_as_si(text, "m", option);
}

drawing::ImportedCase import_drawing(const ImportOptions& options, const std::string& source) {
  const drawing::Drawing drawing = drawing::read_drawing(options.files.front());
  drawing::SectionOptions meaning{
      .unit = find_unit(drawing, options), .role = {}, .base = {}, .layers = options.layers, .form = {}, .snap = {}};
  if (!options.role.empty())
    meaning.role = options.role == "tops" ? drawing::LineRole::tops : drawing::LineRole::bottoms;
  if (!options.base.empty()) meaning.base = read_length(options.base, "--base");
  if (!options.form.empty())
    meaning.form = options.form == "layers" ? drawing::SectionForm::layers : drawing::SectionForm::regions;
  if (!options.snap.empty()) meaning.snap = read_length(options.snap, "--snap");
  drawing::DrawnSection section = drawing::find_section(drawing, meaning);
  section.remarks.push_back("strengths and weights are to be completed");
  return {drawing::write_case(section, source), std::move(section.remarks)};
}

drawing::ImportedCase import_tables(const ImportOptions& options, const std::string& source) {
  if (!(options.role + options.form + options.snap + options.analysis).empty() || !options.layers.empty())
    fail_input("--lines, --layers, --as, --snap and --analysis have no meaning for tables");
  drawing::SurveyOptions meaning;
  if (!options.units.empty()) meaning.unit = units::parse_as_si("1 " + options.units, "m", "--units");
  if (!options.base.empty()) meaning.base = read_length(options.base, "--base");
  drawing::DrawnSection section = drawing::read_survey(options.files, meaning);
  if (options.units.empty())
    section.remarks.push_back("lengths without a unit count as metres; --units gives another one");
  section.remarks.push_back("strengths and weights are to be completed");
  return {drawing::write_case(section, source), std::move(section.remarks)};
}

bool is_table(const std::string& ending) {
  return ending == ".csv" || ending == ".txt" || ending == ".tsv" || ending == ".dat" || ending == ".xyz";
}

drawing::ImportedCase import_files(const ImportOptions& options) {
  std::string source;
  std::size_t tables = 0;
  for (const std::filesystem::path file : options.files) {
    source += (source.empty() ? "" : ", ") + file.filename().string();
    tables += is_table(to_lower(file.extension().string())) ? 1 : 0;
  }
  if (tables == options.files.size()) return import_tables(options, source);
  if (options.files.size() > 1)
    fail_input("several files must be tables (.csv, .txt, .tsv, .dat or .xyz); give a drawing or GeoStudio file alone");
  const std::filesystem::path file = options.files.front();
  return to_lower(file.extension().string()) == ".gsz"
             ? drawing::translate_model(drawing::read_model(file), options.analysis, source)
             : import_drawing(options, source);
}

void import_file(const ImportOptions& options) {
  if (!options.overwrite && std::filesystem::exists(options.output))
    fail_input("'{}' exists; give another name with -o, or --overwrite", options.output.string());
  const drawing::ImportedCase found = import_files(options);
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
      "Make a case file of a section from tables of lines or boreholes (.csv), from CAD or GIS (DXF, GeoPackage, "
      "GeoJSON), or from a GeoStudio file (.gsz)");
  const auto options = std::make_shared<ImportOptions>();
  command
      .take(
          "files", options->files,
          "The drawing, the GeoStudio file, or tables: the ground and lower boundaries from the top down, or boreholes")
      .required()
      .shown_as("FILE");
  command.take("-o,--output", options->output, "Case file to write").required().shown_as("CASE");
  command.take("--units", options->units, "Unit of length of the drawing or table, if it states none or a wrong one")
      .shown_as("UNIT");
  command.take("--layers", options->layers, "Layer of the drawing to use; once for each").one_each().shown_as("NAME");
  command
      .take("--lines", options->role,
            "Lines are the bottoms or the tops of the soils of their layers (default: bottoms)")
      .one_of({"bottoms", "tops"});
  command
      .take("--as", options->form,
            "Write layers, or the regions that the lines of a drawing enclose (default: regions where lines cross)")
      .one_of({"layers", "regions"});
  command
      .take("--snap", options->snap,
            "Distance below which ends of lines meet others [m] (default: 1e-4 of the section)")
      .shown_as("LENGTH");
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
