# libtalus-local: worlds, edits and saves behind a C interface (include/talus_local.h), without sockets and TLS.
file(STRINGS include/talus_local.h local_api_version REGEX "^#define TALUS_LOCAL_API_M(AJ|IN)OR ")
string(REGEX REPLACE "[^;0-9]*([0-9]+)" "\\1" local_api_version "${local_api_version}")
list(GET local_api_version 0 local_api_major)
list(JOIN local_api_version "." local_api_version)

add_library(talus_local_c SHARED
  src/edit_argument.cpp
  src/local/land.cpp
  src/local/talus_local.cpp)
target_include_directories(talus_local_c PUBLIC include PRIVATE src)
target_compile_definitions(talus_local_c PRIVATE TALUS_BUILDS_LIBRARY TALUS_VERSION="${PROJECT_VERSION}")
target_link_libraries(talus_local_c PRIVATE talus_flags talus::edits talus::local talus::saves talus::terrain talus::voxel
  talus::world_files)
talus_optimise(talus_local_c 2)
set(map ${CMAKE_CURRENT_SOURCE_DIR}/src/libtalus-local.map)
# What no function of the map needs is left out.
target_link_options(talus_local_c PRIVATE LINKER:--version-script=${map} LINKER:--gc-sections)
set_target_properties(talus_local_c PROPERTIES
  LINK_DEPENDS ${map} OUTPUT_NAME talus-local VERSION ${local_api_version} SOVERSION ${local_api_major}
  CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON INSTALL_RPATH "\$ORIGIN")

add_executable(talus_single_player EXCLUDE_FROM_ALL examples/single_player.c)
set_target_properties(talus_single_player PROPERTIES
  OUTPUT_NAME single_player C_STANDARD 99 C_STANDARD_REQUIRED ON C_EXTENSIONS OFF)
target_compile_options(talus_single_player PRIVATE -Wall -Wextra -pedantic -Werror)
target_link_libraries(talus_single_player PRIVATE talus_local_c)
if(TALUS_SANITIZE)
  target_link_options(talus_single_player PRIVATE -fsanitize=${TALUS_SANITIZE})
endif()

configure_file(talus-local.pc.in ${CMAKE_CURRENT_BINARY_DIR}/talus-local.pc @ONLY)
install(TARGETS talus_local_c LIBRARY COMPONENT c_api NAMELINK_COMPONENT c_api)
install(TARGETS talus_local_c LIBRARY COMPONENT libtalus-local1 NAMELINK_SKIP EXCLUDE_FROM_ALL)
install(TARGETS talus_local_c LIBRARY COMPONENT libtalus-dev NAMELINK_ONLY EXCLUDE_FROM_ALL)
foreach(rule "c_api" "libtalus-dev;EXCLUDE_FROM_ALL")
  install(FILES include/talus_local.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT ${rule})
  install(FILES ${CMAKE_CURRENT_BINARY_DIR}/talus-local.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig
    COMPONENT ${rule})
endforeach()
