// SPDX-License-Identifier: MIT
#pragma once
// [project]: the title block of a report.

#include <string>

#include "input/language/spec.hpp"

namespace talus::input {

/// What the title block of a report shows besides the title.
struct Project {
  std::string name, client, author, checked_by, revision, notes;
};

template <class Visitor>
void describe(Visitor& v, Project& p) {
  v.key("name", p.name, plain().example(R"("Bypass, cut 3")"), "Name or number of the project.");
  v.key("client", p.client, plain().example(R"("County road office")"), "For whom.");
  v.key("author", p.author, plain().example(R"("A. Engineer")"), "Who prepared the case.");
  v.key("checked_by", p.checked_by, plain().example(R"("B. Engineer")"), "Who checked it.");
  v.key("revision", p.revision, plain().example(R"("A")"), "Revision of the case.");
  v.key("notes", p.notes, plain().example(R"("Preliminary design")"), "Anything a reader of the report must know.");
}

}  // namespace talus::input
