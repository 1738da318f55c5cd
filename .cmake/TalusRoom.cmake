# How every target of this house is compiled.
find_package(PkgConfig REQUIRED)
find_package(Threads REQUIRED)
find_package(glm REQUIRED)
find_package(tl-expected REQUIRED)

# Debian's glm and flatbuffers packages put their headers in /usr/include; tl::expected ships a target.
add_library(talus_flags INTERFACE)
target_compile_features(talus_flags INTERFACE cxx_std_20)
# No fused multiply-add anywhere: generation is the same to the bit on every machine (docs/DESIGN.md).
target_compile_options(talus_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion -Wshadow -ffp-contract=off
  # g++ 12 sees overlapping copies in "literal" + std::string where there are none (GCC bug 105651).
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
  # libstdc++ silences these three for its own char_traits by pragmas, which g++ loses in a precompiled header.
  # Builds without precompiled headers keep them; ./dev test --full makes one of this compiler.
  "$<$<AND:$<CXX_COMPILER_ID:GNU>,$<NOT:$<BOOL:${CMAKE_DISABLE_PRECOMPILE_HEADERS}>>>:-Wno-array-bounds;-Wno-stringop-overflow;-Wno-stringop-overread>"
  $<$<BOOL:${TALUS_WARNINGS_AS_ERRORS}>:-Werror>)
if(TALUS_SANITIZE)
  target_compile_options(talus_flags INTERFACE -fsanitize=${TALUS_SANITIZE} -fno-sanitize-recover=all
    -fno-omit-frame-pointer)
  target_link_options(talus_flags INTERFACE -fsanitize=${TALUS_SANITIZE})
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # Instrumented code confuses these; the sanitizers see better. Asio's fences (-Wtsan) stand beside locks.
    target_compile_options(talus_flags INTERFACE -Wno-maybe-uninitialized -Wno-mismatched-new-delete -Wno-tsan)
  endif()
endif()

# What most files read, parsed once for each target instead of once for each file. Every file still includes what it
# uses: the presets of clang and the sanitizers build without precompiled headers.
set(talus_precompiled <algorithm> <array> <chrono> <cmath> <cstdint> <filesystem> <fstream> <functional> <map> <memory>
  <optional> <span> <sstream> <string> <string_view> <unordered_map> <utility> <vector> <glm/vec3.hpp> <tl/expected.hpp>)
set(talus_precompiled_net ${talus_precompiled} <asio/awaitable.hpp> <asio/co_spawn.hpp> <asio/io_context.hpp>
  <asio/ip/tcp.hpp> <asio/steady_timer.hpp> <asio/use_awaitable.hpp> <asio/write.hpp> <talus/protocol/message.h>)

# talus_brief_sources(SOURCE...): sources that run once, or seldom, and instantiate libraries that take many seconds to
# optimise. They go without the precompiled headers, which are for the target's own level.
function(talus_brief_sources)
  set_source_files_properties(${ARGV} PROPERTIES COMPILE_OPTIONS $<$<CONFIG:Release>:-O1> SKIP_PRECOMPILE_HEADERS ON)
endfunction()

# talus_room(NAME SOURCES ... PUBLIC rooms and libraries ... PRIVATE ...): a static library whose headers
# lie in include/talus/<room>, known to those who link talus::NAME and to nobody else.
function(talus_room name)
  cmake_parse_arguments(ROOM "" "" "SOURCES;PUBLIC;PRIVATE" ${ARGN})
  add_library(talus_${name} STATIC ${ROOM_SOURCES})
  add_library(talus::${name} ALIAS talus_${name})
  set_target_properties(talus_${name} PROPERTIES EXPORT_NAME ${name} POSITION_INDEPENDENT_CODE ON)
  target_compile_features(talus_${name} PUBLIC cxx_std_20)
  target_include_directories(talus_${name}
    PUBLIC $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>
    PRIVATE ${CMAKE_CURRENT_SOURCE_DIR}/src)
  target_link_libraries(talus_${name} PUBLIC ${ROOM_PUBLIC} PRIVATE $<BUILD_INTERFACE:talus_flags> ${ROOM_PRIVATE})
endfunction()

# talus_program(NAME SOURCES ... LINK ...): an executable.
function(talus_program name)
  cmake_parse_arguments(PROGRAM "" "" "SOURCES;LINK" ${ARGN})
  add_executable(${name} ${PROGRAM_SOURCES})
  target_compile_definitions(${name} PRIVATE TALUS_VERSION="${PROJECT_VERSION}")
  target_link_libraries(${name} PRIVATE talus_flags ${PROGRAM_LINK})
endfunction()

# Asio without Boost. clang with libstdc++ needs to be told that it has coroutines.
add_library(talus_asio INTERFACE)
add_library(talus::asio ALIAS talus_asio)
set_target_properties(talus_asio PROPERTIES EXPORT_NAME asio)
# Whether Asio uses aligned_alloc depends on what was included before it; a frame made in one file and freed in
# another would then be freed the wrong way.
# Not ASIO_NO_DEPRECATED: it changes inline functions, so that every file of a game which links the client library would
# have to set it too.
target_compile_definitions(talus_asio INTERFACE ASIO_STANDALONE ASIO_DISABLE_STD_ALIGNED_ALLOC
  $<$<CXX_COMPILER_ID:Clang>:ASIO_HAS_CO_AWAIT=1> $<$<CXX_COMPILER_ID:Clang>:ASIO_HAS_STD_COROUTINE=1>)
target_link_libraries(talus_asio INTERFACE Threads::Threads)
