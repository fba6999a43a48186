// SPDX-License-Identifier: MIT
#pragma once
// The commands of the program. Every function adds its command to the command line.

#include <string>

#include "app/command_line.hpp"

namespace talus::app {

/// "talus 0.2.0 (source …)".
std::string write_version();
/// Throws Error if the environment requests a level of the instruction set other than that of this program.
void check_asked_level();

void add_run(CLI::App& app);
void add_study(CLI::App& app);
void add_collect(CLI::App& app);
void add_point(CLI::App& app);
void add_calibrate(CLI::App& app);
void add_plot(CLI::App& app);
void add_report(CLI::App& app);
void add_check(CLI::App& app);
void add_manual(CLI::App& app);
void add_template(CLI::App& app);
void add_schema(CLI::App& app);
void add_version(CLI::App& app);

}  // namespace talus::app
