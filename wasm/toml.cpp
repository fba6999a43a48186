// SPDX-License-Identifier: MIT
// The parser of toml++, compiled once.
#define TOML_IMPLEMENTATION
#include <toml++/toml.h>
