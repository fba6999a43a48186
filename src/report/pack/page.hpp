// SPDX-License-Identifier: MIT
#pragma once
// The page that a report is filled into; it stands inside the program (cmake/TalusReportPage.cmake).

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "report/pack/pack.hpp"

namespace talus::report {

/// The empty page as it was built.
std::string_view get_page();

/// `page` with the document and its arrays in place of the placeholder <!--TALUS_DATA-->, and `title` as the name
/// of its window. Throws Error (internal_error) when the page has no such placeholder.
std::string fill_page(std::string_view page, const std::string& title, const nlohmann::json& document,
                      const std::vector<PackedText>& arrays);

}  // namespace talus::report
