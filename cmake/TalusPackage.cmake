# SPDX-License-Identifier: MIT
# `cpack`: the Debian packages talus (program, Python package, manual page, completions, examples, manual) and talus-dev (library, headers).
# Their dependencies follow from the libraries that they are linked with (dpkg-shlibdeps).

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME talus)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_CONTACT "the Talus authors")
set(CPACK_PACKAGE_DIRECTORY ${CMAKE_BINARY_DIR}/packages)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_COMPONENTS_ALL program development)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME talus)
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION "Slope stability and runout by LEM, FEM, limit analysis and MPM
 Factor of safety, mechanism and runout of slopes in dry, saturated and unsaturated soil, bare or rooted, from one case file, with a report.")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "python3-numpy, python3-tomli-w, gnuplot-nox")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_CONTROL_EXTRA ${PROJECT_SOURCE_DIR}/tools/package/prerm)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME talus-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SHLIBDEPS OFF)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libgmsh-dev, libtomlplusplus-dev, libudunits2-dev, libhdf5-dev, libceres-dev, libnlopt-dev, libmetis-dev, libzip-dev, libpugixml-dev, nlohmann-json3-dev, libfmt-dev, zlib1g-dev")
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION "Library and headers of Talus, slope stability and runout
 For programs that are built on the library; find_package(talus) finds it.")
if(TALUS_LEVELS)
  set(CPACK_INSTALL_CMAKE_PROJECTS "")
  foreach(build package-v4 package-v3 package)
    list(APPEND CPACK_INSTALL_CMAKE_PROJECTS ${PROJECT_SOURCE_DIR}/build/${build} talus ALL /)
  endforeach()
endif()
include(CPack)
