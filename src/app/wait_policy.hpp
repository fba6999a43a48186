// SPDX-License-Identifier: MIT
#pragma once
// OpenMP threads sleep instead of spinning while they wait.

namespace talus::app {

/// Sets environment variables by which waiting OpenMP threads sleep. Returns true if they were changed. OpenMP reads
/// its settings when a program is loaded, before main(), so they apply to the next program that is started.
bool set_wait_policy();

/// Sets the wait policy and starts the program again; returns if nothing has to be changed or if that is not possible.
void let_waiting_threads_sleep(char** argv);

}  // namespace talus::app
