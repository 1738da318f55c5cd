# Installs TALUS_DOCUMENTS of TALUS_SOURCES, by way of TALUS_BUILT. A link to what is not installed becomes its text.
cmake_minimum_required(VERSION 3.25)
cmake_path(ABSOLUTE_PATH TALUS_DOCDIR BASE_DIRECTORY "${CMAKE_INSTALL_PREFIX}")
foreach(document IN LISTS TALUS_DOCUMENTS)
  file(READ "${TALUS_SOURCES}/${document}" text)
  foreach(target "#" "http" ${TALUS_DOCUMENTS})
    string(REPLACE "](${target}" "](@${target}" text "${text}")  # links that stay
  endforeach()
  string(REGEX REPLACE "!?\\[(`[^`]*`|[^]]*)\\]\\([^@)][^)]*\\)" "\\1" text "${text}")
  string(REPLACE "](@" "](" text "${text}")
  if(CMAKE_INSTALL_PREFIX STREQUAL "/usr")  # by a package
    string(REPLACE "/usr/local/etc/" "/etc/" text "${text}")
    string(REPLACE "/usr/local/" "/usr/" text "${text}")
  endif()
  file(WRITE "${TALUS_BUILT}/${document}" "${text}")
  file(INSTALL "${TALUS_BUILT}/${document}" DESTINATION "${TALUS_DOCDIR}")
endforeach()
