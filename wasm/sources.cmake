# SPDX-License-Identifier: MIT
# Sources of the engine: whole folders, without what needs processes, threads, compiled libraries or a mesh generator, or serves results.
set(folders base input lem material mesh results run/lem site studio)
list(TRANSFORM folders PREPEND ${source}/)
list(TRANSFORM folders APPEND /*.cpp)
file(GLOB_RECURSE TALUS_WASM_SOURCES CONFIGURE_DEPENDS ${folders})
string(JOIN "|" left_out
  "base/(aligned|folder_lock|foreign_code|interrupts|memory|ranks|unit_database)"
  "mesh/(check_mesh_file|generate|points|quality)"
  "material/external"
  "results/(json|schema|table_visitor|tables)"
  "studio/(comparison|exports|method_check|process|run_progress|run_queue|server|workspace)"
  "site/(flow_measures|known_state|mesh_sides|season|seepage_model)")
list(FILTER TALUS_WASM_SOURCES EXCLUDE REGEX "/(${left_out})\\.cpp$")
foreach(name common/section_of_case common/bars_of_case case_picture message_places picture_conditions picture_search)
  list(APPEND TALUS_WASM_SOURCES ${source}/run/${name}.cpp)
endforeach()
