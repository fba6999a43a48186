// SPDX-License-Identifier: MIT
// Checks of [output]: the stage at which times start, and sections.
#include "input/case/output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/text.hpp"
#include "base/user_file.hpp"
#include "input/case/checks.hpp"

namespace talus::input {
namespace {

void check_section(const SectionLine& section, const std::string& path, Findings& findings) {
  // The name is used as a file name, as an anchor on the page, and in texts like those of [[compare]].
  if (findings.is_sound(path + ".name")) {
    if (section.name.empty() || section.name.front() == '.' ||
        section.name.find_first_of("/\\,\"[]") != std::string::npos)
      findings.add(
          path + ".name",
          "a section's name is that of a file; it must not be empty, begin with a point, or hold / \\ , \" [ ]");
    else if (const std::string fault = find_name_fault(make_printable(section.name)); !fault.empty())
      findings.add(path + ".name", "a section's name is that of a file: " + fault);
  }
  if (!findings.is_sound(path + ".from") || !findings.is_sound(path + ".to")) return;
  double square = 0;
  for (std::size_t d = 0; d < 3; ++d) square += (section.to[d] - section.from[d]) * (section.to[d] - section.from[d]);
  if (square == 0) findings.add(path + ".to", "'from' and 'to' are the same point; a section needs a length");
}

}  // namespace

void check_output(const Case& data, Findings& findings) {
  const std::string& stage = data.output.count_from;
  if (!stage.empty() && findings.is_sound("stage") && findings.is_sound("output.count_from") &&
      std::none_of(data.stages.begin(), data.stages.end(), [&](const Stage& s) { return s.name == stage; }))
    findings.add("output.count_from", fmt::format("there is no stage '{}'", stage));
  std::set<std::string> names;
  for (std::size_t i = 0; i < data.output.sections.size(); ++i) {
    const std::string path = fmt::format("output.section.{}", i);
    check_section(data.output.sections[i], path, findings);
    if (findings.is_sound(path + ".name") && !names.insert(data.output.sections[i].name).second)
      findings.add(path + ".name", fmt::format("there are two sections named '{}'", data.output.sections[i].name));
  }
}

}  // namespace talus::input
