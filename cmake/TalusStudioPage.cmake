# SPDX-License-Identifier: MIT
# The page of `talus studio`: a folder of files beside the program, built from web/studio with the Node of
# cmake/TalusReportPage.cmake. Without Node the program has no page of its own (`talus studio --page FOLDER`).
if(TALUS_NPM AND node_version GREATER_EQUAL 20)
  set(studio_folder ${CMAKE_RUNTIME_OUTPUT_DIRECTORY}/studio)
  set(studio_stamp ${PROJECT_BINARY_DIR}/web/studio.stamp)
  file(GLOB_RECURSE studio_sources CONFIGURE_DEPENDS ${web}/studio/src/* ${web}/studio/public/*)
  add_custom_command(OUTPUT ${studio_stamp}
    COMMAND ${CMAKE_COMMAND} -DWEB=${web} -DSTUDIO_DIR=${studio_folder} -DSTAMP=${studio_stamp} -DNPM=${TALUS_NPM}
            -P ${CMAKE_CURRENT_LIST_DIR}/build_studio_page.cmake
    # The report's page installs the packages.
    DEPENDS ${studio_sources} ${TALUS_PAGE_FILE} ${web}/studio/index.html ${web}/studio/vite.config.ts
            ${CMAKE_CURRENT_LIST_DIR}/build_studio_page.cmake
    COMMENT "Building the page of the studio"
    VERBATIM)
  add_custom_target(talus_studio_page DEPENDS ${studio_stamp})
  install(DIRECTORY ${studio_folder}/ DESTINATION ${CMAKE_INSTALL_DATADIR}/talus/studio COMPONENT program OPTIONAL)
endif()
