// SPDX-License-Identifier: MIT
#pragma once
// Warnings on supports that are allowed but probably not meant.

namespace talus::input {

struct Case;
class Findings;

/// Warns of bars that cross in the section.
void warn_of_supports(const Case& data, Findings& findings);

}  // namespace talus::input
