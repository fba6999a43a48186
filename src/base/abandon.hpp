// SPDX-License-Identifier: MIT
#pragma once
// Work that cannot look for interruptions itself, because a library does it.

#include <functional>
#include <string>

namespace talus {

/// Does `work` on a thread of its own and returns when it is done; what it throws is thrown here. When SIGINT or
/// SIGTERM arrives meanwhile (base/interrupt.hpp), throws Error (interrupted) within a tenth of a second: "interrupted
/// while `doing`". The work then goes on in the background and its results are thrown away, so it must own all that it
/// touches.
void do_or_abandon(const std::string& doing, std::function<void()> work);

/// Whether abandoned work still goes on. The program must then end by std::_Exit: destructors of what the work uses
/// would pull it away.
bool is_work_abandoned();

}  // namespace talus
