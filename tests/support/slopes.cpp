// SPDX-License-Identifier: MIT
#include "support/slopes.hpp"

#include <fstream>
#include <sstream>

#include "input/language/parse.hpp"

namespace talus::support {

std::string write_slope(const std::string& name, const std::vector<std::string>& changes) {
  const std::string path = TALUS_SOURCE_DIR "/tests/support/slopes/" + name + ".toml";
  std::ostringstream text;
  if (!(text << std::ifstream(path).rdbuf())) throw Error(ExitCode::wrong_input, path + " cannot be read");
  if (changes.empty()) return text.str();
  std::vector<input::Override> overrides;
  for (const std::string& change : changes) overrides.push_back(input::parse_override(change));
  toml::table slope = toml::parse(text.str(), path);
  input::Places places;
  input::Findings findings(places);
  input::apply_overrides(slope, overrides, findings);
  if (!findings.empty()) throw InputError(findings.sort());
  text.str("");
  text << toml::toml_formatter(slope, toml::toml_formatter::default_flags & ~toml::format_flags::allow_literal_strings)
       << "\n";
  return text.str();
}

}  // namespace talus::support
