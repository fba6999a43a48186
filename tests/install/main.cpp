// SPDX-License-Identifier: MIT
// Reads a case with the installed library and prints its title.

#include <cstdio>

#include "input/read.hpp"

int main(int count, char** arguments) {
  if (count != 2) return 1;
  std::puts(talus::input::read_case(arguments[1]).data.title.c_str());
  return 0;
}
