// SPDX-License-Identifier: MIT
#pragma once
// Parts of the program that are loaded where they are asked for, because what they need is not everywhere: MPI, CUDA.

#include <string>

namespace talus {

/// Loads a module such as "libtalus_ranks.so", which stands beside the program or in the folder lib/talus of where it
/// or Python's package is installed, and returns its function `maker`. nullptr where there is no such module, and `why`
/// says what was the matter. Throws Error (wrong_input) where it is of another version. `global`: its symbols serve
/// what it loads itself.
void* load_module(const std::string& name, const char* maker, bool global, std::string& why);

}  // namespace talus
