// SPDX-License-Identifier: MIT
#pragma once
// The report at the end of a run or a study.

#include <filesystem>
#include <functional>

namespace talus::app {

/// Does `work`, then writes `folder`/report.html, also when the work threw after it had begun, unless it was
/// interrupted: the report then says how far it came. The exception of the work is thrown again; a report that cannot
/// be written is an error only when the work succeeded.
void do_and_report(const std::filesystem::path& folder, bool wants_report, const std::function<void()>& work);

}  // namespace talus::app
