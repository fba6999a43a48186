# SPDX-License-Identifier: MIT
# Builds the page in WEB into PAGE_DIR with NPM: `cmake -DWEB=... -DPAGE_DIR=... -DNPM=... -P build_report_page.cmake`.
# npm keeps a copy of the lock file in node_modules: when that is not older, the packages are the right ones.
set(installed ${WEB}/node_modules/.package-lock.json)
if(NOT EXISTS ${installed} OR NOT ${installed} IS_NEWER_THAN ${WEB}/package-lock.json)
  execute_process(COMMAND ${NPM} ci --no-audit --no-fund WORKING_DIRECTORY ${WEB} RESULT_VARIABLE failed)
  if(failed)
    # Without a network the program is still worth building.
    message(WARNING "npm could not install the packages of web/package-lock.json: `talus report` will write a plain page, "
      "with the answer in words and without viewer and curves. Build again with a network, or name a page that was built "
      "elsewhere with -DTALUS_REPORT_PAGE=FILE.")
    file(COPY_FILE ${WEB}/../src/report/pack/plain_page.html ${PAGE_DIR}/index.html)
    # Older than what it is made of, so that the next build tries again.
    execute_process(COMMAND touch -d 2000-01-01 ${PAGE_DIR}/index.html)
    return()
  endif()
endif()
execute_process(COMMAND ${CMAKE_COMMAND} -E env TALUS_PAGE_DIR=${PAGE_DIR} ${NPM} run --silent build
  WORKING_DIRECTORY ${WEB} RESULT_VARIABLE failed)
if(failed OR NOT EXISTS ${PAGE_DIR}/index.html)
  message(FATAL_ERROR "the page of the reports could not be built from web/")
endif()
# A build with the same result leaves the old file; its time must say that it is up to date.
file(TOUCH ${PAGE_DIR}/index.html)
