# SPDX-License-Identifier: MIT
# The page that `talus report` fills, as bytes inside the library. It is built from web/ with Node where there is one;
# Node is needed by this build only, never by the program.
#
#   TALUS_REPORT_PAGE=FILE   a page that was built elsewhere (web/dist/index.html), or src/report/pack/plain_page.html
set(TALUS_REPORT_PAGE "" CACHE FILEPATH "A ready page for reports; empty: built from web/ when Node and npm are there")

set(web ${PROJECT_SOURCE_DIR}/web)
if(TALUS_REPORT_PAGE)
  get_filename_component(TALUS_PAGE_FILE ${TALUS_REPORT_PAGE} ABSOLUTE)
  if(NOT EXISTS ${TALUS_PAGE_FILE})
    message(FATAL_ERROR "TALUS_REPORT_PAGE names '${TALUS_PAGE_FILE}', which does not exist")
  endif()
else()
  find_program(TALUS_NODE node)
  find_program(TALUS_NPM npm)
  set(node_version 0)
  if(TALUS_NODE)
    execute_process(COMMAND ${TALUS_NODE} --version OUTPUT_VARIABLE node_version ERROR_QUIET)
    string(REGEX MATCH "[0-9]+" node_version "${node_version}")
  endif()
  if(TALUS_NPM AND node_version GREATER_EQUAL 20)
    set(TALUS_PAGE_FILE ${PROJECT_BINARY_DIR}/web/index.html)
    file(GLOB_RECURSE page_sources CONFIGURE_DEPENDS ${web}/src/*)
    list(REMOVE_ITEM page_sources ${web}/src/contract/results.ts)  # generated
    add_custom_command(OUTPUT ${TALUS_PAGE_FILE}
      COMMAND ${CMAKE_COMMAND} -DWEB=${web} -DPAGE_DIR=${PROJECT_BINARY_DIR}/web -DNPM=${TALUS_NPM}
              -P ${CMAKE_CURRENT_LIST_DIR}/build_report_page.cmake
      DEPENDS ${page_sources} ${web}/index.html ${web}/vite.config.ts ${web}/tsconfig.json ${web}/package-lock.json
              ${web}/contract/results.schema.json ${web}/contract/types.mjs
              ${CMAKE_CURRENT_LIST_DIR}/build_report_page.cmake
      COMMENT "Building the page of the reports"
      VERBATIM)
  else()
    set(TALUS_PAGE_FILE ${PROJECT_SOURCE_DIR}/src/report/pack/plain_page.html)
    message(WARNING "There is no Node 20 with npm here: `talus report` will write a plain page, with the answer in words "
      "and without viewer and curves. Install Node, or name a page that was built elsewhere with -DTALUS_REPORT_PAGE=FILE.")
  endif()
endif()

set(TALUS_PAGE_DATA ${PROJECT_BINARY_DIR}/generated/report_page.S)
configure_file(${PROJECT_SOURCE_DIR}/src/report/pack/page_data.S.in ${TALUS_PAGE_DATA} @ONLY)
# The assembler reads the page itself, so the build must be told.
set_source_files_properties(${TALUS_PAGE_DATA} PROPERTIES OBJECT_DEPENDS ${TALUS_PAGE_FILE})
target_sources(talus_lib PRIVATE ${TALUS_PAGE_DATA})
if(TALUS_PAGE_FILE MATCHES "^${PROJECT_BINARY_DIR}/")
  target_sources(talus_lib PRIVATE ${TALUS_PAGE_FILE})
endif()
