#pragma once
// The report at the end of a run or a study.

#include <filesystem>
#include <functional>

namespace talus::app {

/// Does `work`, then writes `folder`/report.html, also when the work threw after it had begun: a report says how far it
/// came. What the work threw is thrown again; a report that cannot be written is an error of its own only when the
/// work went well.
void do_and_report(const std::filesystem::path& folder, bool wants_report, const std::function<void()>& work);

}  // namespace talus::app
