// SPDX-License-Identifier: MIT
#include "drawing/import.hpp"

#include <cmath>
#include <filesystem>

#include "base/error.hpp"
#include "base/numbers.hpp"
#include "base/text.hpp"
#include "base/units.hpp"
#include "drawing/section.hpp"
#include "drawing/survey.hpp"

namespace talus::drawing {
namespace {

double select_unit(const Drawing& drawing, const ImportOptions& options) {
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

ImportedCase import_drawing(const ImportOptions& options, const std::string& source) {
  const Drawing drawing = read_drawing(options.files.front());
  SectionOptions meaning{
      .unit = select_unit(drawing, options), .role = {}, .base = {}, .layers = options.layers, .form = {}, .snap = {}};
  if (!options.role.empty()) meaning.role = options.role == "tops" ? LineRole::tops : LineRole::bottoms;
  if (!options.base.empty()) meaning.base = read_length(options.base, "--base");
  if (!options.form.empty()) meaning.form = options.form == "layers" ? SectionForm::layers : SectionForm::regions;
  if (!options.snap.empty()) meaning.snap = read_length(options.snap, "--snap");
  DrawnSection section = find_section(drawing, meaning);
  section.remarks.push_back("strengths and weights are to be completed");
  return {write_case(section, source), std::move(section.remarks)};
}

ImportedCase import_tables(const ImportOptions& options, const std::string& source) {
  if (!(options.role + options.form + options.snap + options.analysis).empty() || !options.layers.empty())
    fail_input("--lines, --layers, --as, --snap and --analysis have no meaning for tables");
  SurveyOptions meaning;
  meaning.is_unit_given = !options.units.empty();
  if (meaning.is_unit_given) meaning.unit = units::parse_as_si("1 " + options.units, "m", "--units");
  if (!options.base.empty()) meaning.base = read_length(options.base, "--base");
  meaning.boreholes = options.boreholes;
  DrawnSection section = read_survey(options.files, meaning);
  section.remarks.push_back("strengths and weights are to be completed");
  return {write_case(section, source), std::move(section.remarks)};
}

bool is_table(const std::string& ending) {
  return ending == ".csv" || ending == ".txt" || ending == ".tsv" || ending == ".dat" || ending == ".xyz" ||
         ending == ".ags";
}

}  // namespace

ImportedCase import_files(const ImportOptions& options) {
  std::string source;
  std::size_t tables = 0;
  for (const std::filesystem::path file : options.files) {
    source += (source.empty() ? "" : ", ") + file.filename().string();
    tables += is_table(to_lower(file.extension().string())) ? 1 : 0;
  }
  if (tables == options.files.size()) return import_tables(options, source);
  if (!options.boreholes.empty()) fail_input("--boreholes has no meaning for a drawing or a GeoStudio file");
  if (options.files.size() > 1)
    fail_input(
        "several files must be tables (.csv, .txt, .tsv, .dat, .xyz or .ags); give a drawing or GeoStudio file alone");
  const std::filesystem::path file = options.files.front();
  return to_lower(file.extension().string()) == ".gsz" ? translate_model(read_model(file), options.analysis, source)
                                                       : import_drawing(options, source);
}

}  // namespace talus::drawing
