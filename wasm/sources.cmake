# SPDX-License-Identifier: MIT
file(GLOB_RECURSE TALUS_WASM_SOURCES CONFIGURE_DEPENDS ${source}/base/*.cpp ${source}/results/*.cpp ${source}/input/*.cpp ${source}/lem/*.cpp ${source}/material/*.cpp
  ${source}/site/*.cpp ${source}/run/lem/*.cpp ${source}/run/common/*.cpp ${source}/mesh/*.cpp)
list(FILTER TALUS_WASM_SOURCES EXCLUDE REGEX "/(base/(foreign_code|aligned|memory|ranks|folder_lock)|mesh/(gmsh_mesh|read_mesh_file|generate|finish)|material/external|run/common/(run_folder|head|mesh_estimate|soil_column)|results/(tables|timeline|json)|input/(echo|start_result)|mesh/(points|quality)|base/unit_database)\\.cpp")
