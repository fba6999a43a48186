# SPDX-License-Identifier: MIT
# Builds the page of the studio in WEB into STUDIO_DIR with NPM:
# `cmake -DWEB=... -DSTUDIO_DIR=... -DSTAMP=... -DNPM=... -P build_studio_page.cmake`.
if(NOT EXISTS ${WEB}/node_modules/.package-lock.json)
  message(WARNING "The packages of web/package-lock.json are not installed: `talus studio` has no page. Build again with a network.")
  return()
endif()
file(REMOVE_RECURSE ${STUDIO_DIR})
execute_process(COMMAND ${CMAKE_COMMAND} -E env TALUS_STUDIO_DIR=${STUDIO_DIR} ${NPM} run --silent studio
  WORKING_DIRECTORY ${WEB} RESULT_VARIABLE failed)
if(failed OR NOT EXISTS ${STUDIO_DIR}/index.html)
  message(FATAL_ERROR "the page of the studio could not be built from web/studio")
endif()
file(TOUCH ${STAMP})
