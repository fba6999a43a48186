// SPDX-License-Identifier: MIT
#pragma once
// Threads of OpenMP that wait for others sleep instead of spinning.

namespace talus::app {

/// Asks OpenMP, by the environment, to let threads that wait for others sleep. True where that was new. OpenMP reads
/// its settings when a program is loaded, before main(): they hold for the program that is started next.
bool set_wait_policy();

/// Sets the wait policy and starts the program again; returns where nothing is to be done or where that is not
/// possible.
void let_waiting_threads_sleep(char** argv);

}  // namespace talus::app
