# SPDX-License-Identifier: MIT
# The commit as a part of the version, for every summary.json: a result must say which source made it.
find_package(Git QUIET)
set(TALUS_COMMIT "unknown")
if(GIT_FOUND)
  execute_process(COMMAND ${GIT_EXECUTABLE} -C ${CMAKE_CURRENT_SOURCE_DIR} describe --always --dirty
    OUTPUT_VARIABLE TALUS_COMMIT OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
endif()
configure_file(${CMAKE_CURRENT_SOURCE_DIR}/src/base/version.hpp.in ${CMAKE_BINARY_DIR}/generated/base/version.hpp @ONLY)
