// SPDX-License-Identifier: MIT
#pragma once
// Threads of OpenMP that wait for others sleep instead of spinning.

namespace talus::app {

/// Makes threads that wait for others sleep. OpenMP reads its settings when the program is loaded, before main(), so
/// the program sets them and starts itself again; returns where nothing is to be done or where that is not possible.
void let_waiting_threads_sleep(char** argv);

}  // namespace talus::app
