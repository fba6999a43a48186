# SPDX-License-Identifier: MIT
# Installation: program, library, headers, and the files by which other projects find them. The component `program` is the Debian
# package `talus`, `development` is `talus-dev` (cmake/TalusPackage.cmake).

include(CMakePackageConfigHelpers)
if(TALUS_LEVELS AND NOT TALUS_ARCH STREQUAL TALUS_FIRST_LEVEL)
  install(TARGETS talus_cli RUNTIME DESTINATION lib/talus/${TALUS_ARCH} COMPONENT program)
  return()
endif()
install(TARGETS talus_lib talus_options EXPORT talus-targets COMPONENT development
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
if(TALUS_LEVELS)
  # Each level of the instruction set has its folder with a whole program; the one in the PATH chooses (src/app/launch).
  install(TARGETS talus_cli RUNTIME DESTINATION lib/talus/${TALUS_ARCH} COMPONENT program)
  install(TARGETS talus_launch RUNTIME DESTINATION lib/talus COMPONENT program)
  install(CODE "file(MAKE_DIRECTORY \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/bin\")
    file(CREATE_LINK ../lib/talus/talus \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/bin/talus\" SYMBOLIC)" COMPONENT program)
else()
  install(TARGETS talus_cli RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
endif()
install(DIRECTORY src/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/talus COMPONENT development FILES_MATCHING PATTERN "*.hpp")
install(FILES ${CMAKE_BINARY_DIR}/generated/base/version.hpp DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/talus/base COMPONENT development)
install(EXPORT talus-targets NAMESPACE talus:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/talus COMPONENT development)
configure_package_config_file(cmake/talus-config.cmake.in ${CMAKE_BINARY_DIR}/talus-config.cmake
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/talus PATH_VARS TALUS_MODULES)
write_basic_package_version_file(${CMAKE_BINARY_DIR}/talus-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/talus-config.cmake ${CMAKE_BINARY_DIR}/talus-config-version.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/talus COMPONENT development)

# Manual page and completions, made of the help of the program.
set(pages ${CMAKE_BINARY_DIR}/pages)
add_custom_command(OUTPUT ${pages}/talus.1.gz ${pages}/talus ${pages}/_talus ${pages}/talus.fish
  COMMAND ${PROJECT_SOURCE_DIR}/tools/package/shell_pages.py $<TARGET_FILE:talus_cli> ${pages}
  DEPENDS talus_cli ${PROJECT_SOURCE_DIR}/tools/package/shell_pages.py VERBATIM)
add_custom_target(shell_pages ALL DEPENDS ${pages}/talus.1.gz)
install(FILES ${pages}/talus.1.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT program)
install(FILES ${pages}/talus DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT program)
install(FILES ${pages}/_talus DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions COMPONENT program)
install(FILES ${pages}/talus.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d COMPONENT program)

install(DIRECTORY examples DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)
install(DIRECTORY docs/manual docs/theory DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)
install(FILES README.md CHANGELOG.md docs/notation.md docs/verification.md docs/reliability.md docs/performance.md
  DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright COMPONENT program)
