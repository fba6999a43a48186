// SPDX-License-Identifier: MIT
// `talus report DIR`: one HTML file that shows what a folder of results holds.

#include "report/report.hpp"

#include <fmt/format.h>

#include <memory>
#include <string>

#include "app/commands.hpp"
#include "base/encoding.hpp"
#include "base/interrupt.hpp"

namespace talus::app {

void add_report(CLI::App& app) {
  const Command command(app, "report", "Write a report of a run or a study as one HTML file");
  const auto folder = std::make_shared<std::string>();
  command.take("DIR", *folder, "Folder of the results of a run or a study; report.html is written there").required();
  command.act([folder] {
    catch_interrupts();
    print(stdout, fmt::format("{}\n", report::write_report(*folder).string()));
  });
}

}  // namespace talus::app
