// SPDX-License-Identifier: MIT
#pragma once
// SIGINT and SIGTERM ask for an orderly end: the calculation looks here between steps, saves itself and stops.

namespace talus {

/// From now on both signals set the flag instead of ending the program; a second one ends it at once.
void catch_interrupts();

/// Whether one of them has arrived.
bool is_interrupted();

/// Throws Error (interrupted) when one has arrived, for work that keeps its results as it goes on.
void throw_if_interrupted();

/// Sets the flag as the signal does, for tests and for programs that embed this one; false clears it.
void request_interrupt(bool wanted = true);

/// Calls `look` wherever the calculation looks for signals, for tests of how often it does; nullptr ends it.
void watch_interrupts(void (*look)());

}  // namespace talus
