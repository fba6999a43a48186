// SPDX-License-Identifier: MIT
#pragma once
// From a case file to a checked case.

#include <set>
#include <string>
#include <vector>

#include "base/json_tree.hpp"
#include "input/case/case.hpp"
#include "input/language/findings.hpp"
#include "input/language/parse.hpp"

namespace talus::input {

/// A case that was read without a fault.
struct LoadedCase {
  Case data;
  JsonTree echo;                     ///< every value with its unit and whether it was given, see input/echo.hpp
  std::string text;                  ///< the file as it is
  std::string file;                  ///< its name, as messages show it
  Places places;                     ///< where each key stands, for faults that are found later
  std::vector<Diagnostic> warnings;  ///< what is allowed and probably not meant
  bool is_whole = true;  ///< false: element tests and their soils, without anything that could be calculated else

  // Compiled once, in read.cpp: the files that hold one would each compile them again.
  LoadedCase();
  LoadedCase(const LoadedCase&);
  LoadedCase(LoadedCase&&) noexcept;
  LoadedCase& operator=(const LoadedCase&);
  LoadedCase& operator=(LoadedCase&&) noexcept;
  ~LoadedCase();
};

/// What a file must hold: a slope that can be calculated, or element tests and their soils without one as well.
enum class CaseScope { whole, whole_or_tests };

/// Reads and checks a case file. Throws InputError with all faults of the file.
LoadedCase read_case(const std::string& path, const std::vector<Override>& overrides = {},
                     CaseScope scope = CaseScope::whole);

/// The same for a text; `name` stands for the file in messages, and mesh files are relative to its folder.
LoadedCase read_case_text(const std::string& text, const std::string& name, const std::vector<Override>& overrides = {},
                          CaseScope scope = CaseScope::whole);

/// Checks the names in a case against those of its mesh, which for a ready file are known only now. `sides` are named
/// sides and lines; `regions` without the empty one. Throws InputError with all faults.
void check_against_mesh(const LoadedCase& loaded, const std::set<std::string>& sides,
                        const std::set<std::string>& regions);

/// Checks a case against the result that it starts from: dimension, points per element, regions, and that the soil of
/// each region has the water and the mass that it had. `input` is the echo of the result's case; its points per element
/// count where this case gives none. Throws InputError with all faults.
void check_against_result(const LoadedCase& loaded, const JsonTree& input);

/// The reference of every key, as Markdown.
std::string write_manual();
/// A commented case file with every key; it can be calculated as it is.
std::string write_template();
/// JSON Schema (draft 2020-12) of case files, for editors.
nlohmann::json write_schema();

// The other files that a case names: a ready mesh, tables of series, compiled soils, the result that it starts from.

/// Their names as the text of a case with these changes gives them, in the order of their keys, each once; a result is
/// named by its folder. The case was read without a fault before.
std::vector<std::string> list_files(const std::string& text, const std::vector<Override>& overrides);

}  // namespace talus::input
