# SPDX-License-Identifier: MIT
# The commit as a part of the version, for every summary.json: a result must say which source made it.
find_package(Git QUIET)
set(TALUS_COMMIT "unknown")
# A source archive has its commit in a file. It may lie in another repository, whose commit is not that of Talus.
file(STRINGS ${CMAKE_CURRENT_SOURCE_DIR}/cmake/commit.txt archived LIMIT_COUNT 1)
if(NOT archived MATCHES "Format")
  set(TALUS_COMMIT "${archived}")
elseif(GIT_FOUND AND EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/.git)
  execute_process(COMMAND ${GIT_EXECUTABLE} -C ${CMAKE_CURRENT_SOURCE_DIR} describe --always --dirty
    OUTPUT_VARIABLE TALUS_COMMIT OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
endif()
configure_file(${CMAKE_CURRENT_SOURCE_DIR}/src/base/version.hpp.in ${CMAKE_BINARY_DIR}/generated/base/version.hpp @ONLY)
