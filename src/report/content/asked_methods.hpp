// SPDX-License-Identifier: MIT
#pragma once
// Which methods a case asks for: slices, finite elements, material points.

#include "report/folder.hpp"

namespace talus::report {

/// A folder that names no method is one of material points.
bool asks_for(const ResultFolder& folder, Method method);

/// Whether it asks for more than material points.
bool asks_for_others(const ResultFolder& folder);

}  // namespace talus::report
