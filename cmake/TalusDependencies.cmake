# SPDX-License-Identifier: MIT
# The libraries, each a Debian package named in tools/apt-packages.txt; docs/decisions/0003 says why each was chosen.
find_package(OpenMP REQUIRED COMPONENTS CXX)
find_package(tomlplusplus REQUIRED)
find_package(nlohmann_json 3 REQUIRED)
find_package(fmt REQUIRED)
find_package(CLI11 REQUIRED)
find_package(HDF5 REQUIRED COMPONENTS C)
find_package(ZLIB REQUIRED)
find_package(Eigen3 REQUIRED NO_MODULE)
find_path(UDUNITS2_INCLUDE_DIR udunits2.h REQUIRED PATH_SUFFIXES udunits2)
find_library(UDUNITS2_LIBRARY udunits2 REQUIRED)
find_path(GMSH_INCLUDE_DIR gmsh.h REQUIRED)
find_library(GMSH_LIBRARY gmsh REQUIRED)
find_path(CERES_INCLUDE_DIR ceres/ceres.h REQUIRED)
find_library(CERES_LIBRARY ceres REQUIRED)
find_library(GLOG_LIBRARY glog REQUIRED) # the headers of Ceres write its messages
find_path(NLOPT_INCLUDE_DIR nlopt.h REQUIRED)
find_library(NLOPT_LIBRARY nlopt REQUIRED)
