// SPDX-License-Identifier: MIT
#pragma once
// Reading and checking of a case file, and the manual, template and schema of its keys.

#include <set>
#include <string>
#include <vector>

#include "base/json_tree.hpp"
#include "input/case/case.hpp"
#include "input/language/findings.hpp"
#include "input/language/parse.hpp"

namespace talus::input {

/// A case without faults.
struct LoadedCase {
  Case data;
  JsonTree echo;                     ///< every value with its unit and whether it was given, see input/echo.hpp
  std::string text;                  ///< contents of the file
  std::string file;                  ///< its name in messages
  Places places;                     ///< places of the keys, for faults that are found later
  std::vector<Diagnostic> warnings;  ///< values that are allowed but probably not intended
  bool is_whole = true;              ///< false: element tests and their soils only
};

/// Required contents of a file: a slope, or alternatively element tests and their soils alone.
enum class CaseScope { whole, whole_or_tests };

/// Reads and checks a case file. Throws InputError with all faults of the file.
LoadedCase read_case(const std::string& path, const std::vector<Override>& overrides = {},
                     CaseScope scope = CaseScope::whole);

/// Reads and checks a case from a text; `name` is the file name in messages, and mesh files are relative to its folder.
LoadedCase read_case_text(const std::string& text, const std::string& name, const std::vector<Override>& overrides = {},
                          CaseScope scope = CaseScope::whole);

/// Checks the names in a case against those of its mesh, after an external mesh is read. `sides` are named sides and
/// lines; `regions` excludes the empty one. Throws InputError with all faults.
void check_against_mesh(const LoadedCase& loaded, const std::set<std::string>& sides,
                        const std::set<std::string>& regions);

/// Checks a case against the result that it starts from: dimension, points per element, regions, and equality of water
/// and mass of the soil in each region. `input` is the echo of the result's case; its points per element apply if this
/// case gives none. Throws InputError with all faults.
void check_against_result(const LoadedCase& loaded, const JsonTree& input);

/// Returns the reference of all keys as Markdown.
std::string write_manual();
/// Returns a commented case file with every key, which can be calculated unchanged.
std::string write_template();
/// Returns the JSON Schema (draft 2020-12) of case files, for editors.
nlohmann::json write_schema();

// Other files that a case refers to: an external mesh, tables of series, compiled soils, the initial result.

/// Returns their names as in the text of a case with these changes, in the order of their keys, without duplicates; a
/// result is listed by its folder. Requires a case without faults.
std::vector<std::string> list_files(const std::string& text, const std::vector<Override>& overrides);

}  // namespace talus::input
