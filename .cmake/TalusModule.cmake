# How every target of this project is compiled.
# Sources NAME_posix.cpp and NAME_windows.cpp are of one platform each.
set(talus_platform posix)
if(WIN32)
  set(talus_platform windows)
endif()
if(NOT (TALUS_ONLY_GOLDEN AND CMAKE_CROSSCOMPILING))
  find_package(PkgConfig REQUIRED)
  find_package(Threads REQUIRED)
endif()
if(CMAKE_CROSSCOMPILING AND (TALUS_ONLY_GOLDEN OR WIN32))
  include(HeaderLibraries)
else()
  find_package(glm REQUIRED)
  find_package(tl-expected REQUIRED)
  find_package(tomlplusplus REQUIRED)
  pkg_check_modules(highway REQUIRED IMPORTED_TARGET GLOBAL libhwy)
  pkg_check_modules(xxhash REQUIRED IMPORTED_TARGET GLOBAL libxxhash)
endif()

# Debian's glm and flatbuffers packages put their headers in /usr/include; tl::expected ships a target.
add_library(talus_flags INTERFACE)
target_compile_features(talus_flags INTERFACE cxx_std_20)
# No fused multiply-add anywhere: generation is the same to the bit on every machine (docs/DESIGN.md).
target_compile_definitions(talus_flags INTERFACE TALUS_NO_CONTRACTION
  $<$<PLATFORM_ID:Windows>:NOMINMAX> $<$<PLATFORM_ID:Windows>:WIN32_LEAN_AND_MEAN>)
if(WIN32 AND NOT TALUS_ONLY_GOLDEN)
  enable_language(RC)
  target_compile_options(talus_flags INTERFACE $<$<COMPILE_LANGUAGE:CXX>:-include> $<$<COMPILE_LANGUAGE:CXX>:${CMAKE_CURRENT_LIST_DIR}/windows/plain_names.h>)
endif()
target_compile_options(talus_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion -Wshadow -ffp-contract=off
  # g++ 12 sees overlapping copies in "literal" + std::string where there are none (GCC bug 105651).
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
  # Where it inlines one of a coroutine frame's new and delete, it takes them for a pair that is none.
  $<$<CXX_COMPILER_ID:GNU>:-Wno-mismatched-new-delete>
  # libstdc++ silences these three for its own char_traits by pragmas, which g++ loses in a precompiled header.
  # Builds without precompiled headers keep them, as release-plain.
  "$<$<AND:$<CXX_COMPILER_ID:GNU>,$<NOT:$<BOOL:${CMAKE_DISABLE_PRECOMPILE_HEADERS}>>>:-Wno-array-bounds;-Wno-stringop-overflow;-Wno-stringop-overread>"
  # There g++ does not align the stack for AVX (GCC bug 54412).
  $<$<AND:$<PLATFORM_ID:Windows>,$<CXX_COMPILER_ID:GNU>>:-Wa,-muse-unaligned-vector-move>
  $<$<BOOL:${TALUS_WARNINGS_AS_ERRORS}>:-Werror>
  $<$<BOOL:${TALUS_WASM}>:-fno-rtti>
  # Without unity sources g++ 12 inlines libstdc++'s vectors and variants otherwise, and reports these where nothing is
  # wrong: they are printed, and are not errors.
  "$<$<AND:$<CXX_COMPILER_ID:GNU>,$<BOOL:${CMAKE_DISABLE_PRECOMPILE_HEADERS}>>:-Wno-error=array-bounds;-Wno-error=stringop-overflow;-Wno-error=maybe-uninitialized>")
if(TALUS_SANITIZE)
  target_compile_options(talus_flags INTERFACE -fsanitize=${TALUS_SANITIZE} -fno-sanitize-recover=all
    -fno-omit-frame-pointer)
  # Without the check of vptr: it opens a pipe to see whether memory is readable, and reports a fault where a test has left
  # the process no descriptors. Without those of null, object-size and pointer-overflow: AddressSanitizer stops at such an
  # access too, and a third of the time to compile was theirs. Functions without their return are -Wreturn-type's.
  if(TALUS_SANITIZE MATCHES undefined)
    target_compile_options(talus_flags INTERFACE -fno-sanitize=vptr,null,object-size,pointer-overflow,return,returns-nonnull-attribute)
  endif()
  target_link_options(talus_flags INTERFACE -fsanitize=${TALUS_SANITIZE})
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # Instrumented code confuses these; the sanitizers see better. Asio's fences (-Wtsan) stand beside locks.
    target_compile_options(talus_flags INTERFACE -Wno-maybe-uninitialized -Wno-tsan)
  endif()
endif()

# What most test files read, parsed once instead of once for each file. Every file still includes what it uses: the
# presets release-plain and clang have neither precompiled headers nor unity sources.
set(talus_precompiled <algorithm> <array> <chrono> <cmath> <cstdint> <filesystem> <fstream> <functional> <map> <memory>
  <optional> <span> <sstream> <string> <string_view> <unordered_map> <utility> <vector> <glm/vec3.hpp> <tl/expected.hpp>)
set(talus_precompiled_net ${talus_precompiled} <asio/awaitable.hpp> <asio/co_spawn.hpp> <asio/io_context.hpp>
  <asio/ip/tcp.hpp> <asio/steady_timer.hpp> <asio/use_awaitable.hpp> <asio/write.hpp> <talus/protocol/message.h>)

# g++ collects garbage only from 300 MB on. Collecting was 5 to 6 % of the time of server/net and server/chunks.
if(CMAKE_UNITY_BUILD AND CMAKE_BUILD_TYPE STREQUAL Release)
  target_compile_options(talus_flags INTERFACE "$<$<CXX_COMPILER_ID:GNU>:SHELL:--param ggc-min-heapsize=300000>")
endif()

# A quick build (TALUS_QUICK, by ./dev run) has no more than one machine needs that tries talusd: kernels for this machine
# alone, generation by -O2 and not -O3, all else by less (talus_optimise()). A build with tests is never quick.
if(TALUS_QUICK AND CMAKE_UNITY_BUILD AND NOT (TALUS_TESTS OR TALUS_BENCH OR TALUS_FUZZ))
  set(talus_quick ON)
  string(REPLACE "-O3" "-O2" CMAKE_CXX_FLAGS_RELEASE "${CMAKE_CXX_FLAGS_RELEASE}")
endif()

# Unity builds (CMAKE_UNITY_BUILD, on in the release preset): a target's sources are compiled together, up to this many
# at once, so that what they include is parsed and instantiated once. Names in anonymous namespaces are then shared.
if(NOT DEFINED CMAKE_UNITY_BUILD_BATCH_SIZE)
  set(CMAKE_UNITY_BUILD_BATCH_SIZE 24)
endif()
if(CMAKE_UNITY_BUILD)
  # In a unity source every file but the unity source itself counts as a header.
  target_compile_options(talus_flags INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>
    # clang reports a local name that another file has in its anonymous namespace.
    $<$<CXX_COMPILER_ID:Clang>:-Wno-shadow>)
endif()

# talus_alone(SOURCE...): sources that stay out of unity builds.
function(talus_alone)
  set_source_files_properties(${ARGV} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()

# talus_brief_sources(SOURCE...): sources that run once, or seldom, and instantiate libraries that take many seconds to
# optimise. They go without the precompiled headers, which are for the target's own level.
function(talus_brief_sources)
  set_source_files_properties(${ARGV} PROPERTIES COMPILE_OPTIONS $<$<CONFIG:Release>:-O1> SKIP_PRECOMPILE_HEADERS ON)
endfunction()

# talus_once(SOURCE...): sources that run once, when a world is read. For WebAssembly they are made small, each by itself.
function(talus_once)
  if(TALUS_WASM)
    set_source_files_properties(${ARGV} PROPERTIES COMPILE_OPTIONS -Oz)
  endif()
endfunction()

# talus_optimise(TARGET LEVEL): its level in a release build: 3 for what is hot, as it is by default; 2 for what mostly waits
# for the network; g for what runs once, or waits for a disk or a terminal: it compiles in a sixth less time than 1.
# A quick build has less than 3 and 2: -O1 that inlines small functions compiles in three quarters of the time of -O2. How
# much slower talusd runs by it was not measured. -O0 takes as long to compile as -Og.
function(talus_optimise target level)
  set(options -O${level})
  if(TALUS_WASM AND level STREQUAL "g")
    set(options -Oz)
  endif()
  if(talus_quick)
    set(options_3 -O1 $<$<CXX_COMPILER_ID:GNU>:-finline-small-functions> $<$<CXX_COMPILER_ID:GNU>:-findirect-inlining>)
    set(options_2 -Og)
    set(options_g -Og)
    set(options ${options_${level}})
  endif()
  target_compile_options(${target} PRIVATE "$<$<CONFIG:Release>:${options}>")
endfunction()

# talus_join_kernels(VARIABLE NAME KERNEL...): a kernel source includes itself once for each instruction set (Highway's
# foreach_target.h), which a unity source cannot. In a unity build a source of the same kind includes them all for each
# set, so that Highway is parsed once for each set and not once more for each kernel.
function(talus_join_kernels variable name)
  if(NOT CMAKE_UNITY_BUILD)
    set(${variable} ${ARGN} PARENT_SCOPE)
    return()
  endif()
  set(joined ${CMAKE_CURRENT_BINARY_DIR}/${name}_kernels.cpp)
  set(own "#undef HWY_TARGET_INCLUDE\n#define HWY_TARGET_INCLUDE \"${joined}\"\n")
  # Which sets are disabled is known before the first is chosen.
  set(text "#include <talus/vectors/tables.h>\n${own}#include <hwy/foreach_target.h>\n")
  foreach(kernel IN LISTS ARGN)
    string(APPEND text "#include \"${CMAKE_CURRENT_SOURCE_DIR}/${kernel}\"\n")
  endforeach()
  # Each kernel names itself as what is included next.
  file(CONFIGURE OUTPUT ${joined} CONTENT "${text}${own}" @ONLY)
  talus_alone(${joined})
  set(${variable} ${joined} PARENT_SCOPE)
endfunction()

# talus_kernel_sources(SOURCE...): sources that are compiled for each instruction set; in a quick build for scalar and the best
# of this machine.
function(talus_kernel_sources)
  if(talus_quick)
    execute_process(COMMAND ${CMAKE_CXX_COMPILER} -march=native -dM -E -x c++ /dev/null OUTPUT_VARIABLE macros ERROR_QUIET)
    if(macros MATCHES "__AVX512VL__" AND macros MATCHES "__AVX512BW__" AND macros MATCHES "__AVX512DQ__")
      set(others "HWY_AVX2|HWY_SSE4")
    elseif(macros MATCHES "__AVX2__" AND macros MATCHES "__BMI2__" AND macros MATCHES "__FMA__")
      set(others "HWY_AVX3|HWY_SSE4")
    elseif(macros MATCHES "__SSE4_2__")
      set(others "HWY_AVX3|HWY_AVX2")
    else()
      return()
    endif()
    set_property(SOURCE ${ARGV} APPEND PROPERTY COMPILE_DEFINITIONS "TALUS_OTHER_TARGETS=(${others})")
  endif()
endfunction()

# talus_module(NAME SOURCES ... KERNELS ... PUBLIC modules and libraries ... PRIVATE ...): a static library whose headers
# lie in include/talus/<module>, visible only to targets that link talus::NAME. KERNELS are sources that include
# themselves once for each instruction set.
function(talus_module name)
  cmake_parse_arguments(MODULE "" "" "SOURCES;KERNELS;PUBLIC;PRIVATE" ${ARGN})
  if(MODULE_KERNELS)
    talus_join_kernels(MODULE_KERNELS ${name} ${MODULE_KERNELS})
    talus_kernel_sources(${MODULE_KERNELS})
  endif()
  add_library(talus_${name} STATIC ${MODULE_SOURCES} ${MODULE_KERNELS})
  list(FILTER MODULE_SOURCES INCLUDE REGEX "_windows\\.cpp$")  # windows.h defines what others take for names
  if(MODULE_SOURCES)
    talus_alone(${MODULE_SOURCES})
  endif()
  if(MODULE_KERNELS AND TALUS_SANITIZE)
    target_compile_options(talus_${name} PRIVATE -O1)  # -Og inlines too little of them
  endif()
  add_library(talus::${name} ALIAS talus_${name})
  set_target_properties(talus_${name} PROPERTIES EXPORT_NAME ${name})
  if(NOT TALUS_WASM)
    set_target_properties(talus_${name} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  endif()
  target_compile_features(talus_${name} PUBLIC cxx_std_20)
  target_include_directories(talus_${name}
    PUBLIC $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>
    PRIVATE ${CMAKE_CURRENT_SOURCE_DIR}/src)
  target_link_libraries(talus_${name} PUBLIC ${MODULE_PUBLIC} PRIVATE $<BUILD_INTERFACE:talus_flags> ${MODULE_PRIVATE})
endfunction()

# talus_server_target(TARGET LEVEL): flags and unity sources of every target of the server.
function(talus_server_target target level)
  target_compile_definitions(${target} PRIVATE TALUS_VERSION="${PROJECT_VERSION}")
  target_link_libraries(${target} PRIVATE talus_flags)
  talus_optimise(${target} ${level})
  # Unity sources of equal size.
  get_target_property(sources ${target} SOURCES)
  list(LENGTH sources count)
  math(EXPR units "(${count} - 1) / ${CMAKE_UNITY_BUILD_BATCH_SIZE} + 1")
  math(EXPR size "(${count} - 1) / ${units} + 1")
  set_target_properties(${target} PROPERTIES UNITY_BUILD_BATCH_SIZE ${size})
endfunction()

# talus_server_module(NAME SOURCES ... SETUP ... LINK libraries ...): makes the folder server/NAME a target
# talus_server_NAME, which links the modules of the server that docs/modules.txt lets it include, so that a test links a
# module by itself. SOURCES are compiled by -O3; SETUP, which runs once or seldom, by -Og.
function(talus_server_module name)
  cmake_parse_arguments(MODULE "" "" "SOURCES;SETUP;LINK" ${ARGN})
  set(target talus_server_${name})
  talus_dependencies(server/${name} depends)
  list(FILTER depends INCLUDE REGEX "^server/")
  list(TRANSFORM depends REPLACE "^server/" "talus_server_")
  if(NOT MODULE_SOURCES)
    add_library(${target} STATIC ${MODULE_SETUP})
    talus_server_target(${target} g)
  else()
    add_library(${target} STATIC ${MODULE_SOURCES})
    talus_server_target(${target} 3)
    if(MODULE_SETUP)
      add_library(${target}_setup OBJECT ${MODULE_SETUP})
      talus_server_target(${target}_setup g)
      target_include_directories(${target}_setup PRIVATE ${PROJECT_SOURCE_DIR}/server)
      target_link_libraries(${target}_setup PRIVATE ${depends} ${MODULE_LINK})
      target_sources(${target} PRIVATE $<TARGET_OBJECTS:${target}_setup>)
    endif()
  endif()
  target_include_directories(${target} PUBLIC ${PROJECT_SOURCE_DIR}/server)
  target_link_libraries(${target} PUBLIC ${depends} ${MODULE_LINK})
endfunction()

# talus_dependencies(MODULE VARIABLE): the modules that docs/modules.txt lets MODULE include.
function(talus_dependencies module variable)
  set(table ${PROJECT_SOURCE_DIR}/docs/modules.txt)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${table})
  file(STRINGS ${table} line REGEX "^${module} *\\|")
  if(NOT line)
    message(FATAL_ERROR "${module} is not in docs/modules.txt")
  endif()
  string(REGEX REPLACE "^[^|]*\\|([^|]*)\\|.*$" "\\1" depends "${line}")
  string(STRIP "${depends}" depends)
  separate_arguments(depends)
  set(${variable} ${depends} PARENT_SCOPE)
endfunction()

# talus_resources(TARGET KIND): on Windows, the resources of windows/KIND.rc: the version, and of a program the manifest.
function(talus_resources target kind)
  if(WIN32)
    if(NOT TARGET talus_${kind}_resources)
      string(REPLACE "." "," numbers ${PROJECT_VERSION})
      add_library(talus_${kind}_resources OBJECT ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/windows/${kind}.rc)
      target_include_directories(talus_${kind}_resources PRIVATE ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/windows)
      target_compile_definitions(talus_${kind}_resources PRIVATE TALUS_VERSION=${PROJECT_VERSION} TALUS_NUMBERS=${numbers})
    endif()
    target_sources(${target} PRIVATE $<TARGET_OBJECTS:talus_${kind}_resources>)
  endif()
endfunction()

# talus_program(NAME SOURCES ... LINK ...): an executable.
function(talus_program name)
  cmake_parse_arguments(PROGRAM "" "" "SOURCES;LINK" ${ARGN})
  add_executable(${name} ${PROGRAM_SOURCES})
  talus_resources(${name} program)
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
  $<$<PLATFORM_ID:Windows>:_WIN32_WINNT=0x0A00>
  $<$<CXX_COMPILER_ID:Clang>:ASIO_HAS_CO_AWAIT=1> $<$<CXX_COMPILER_ID:Clang>:ASIO_HAS_STD_COROUTINE=1>)
target_link_libraries(talus_asio INTERFACE Threads::Threads $<$<PLATFORM_ID:Windows>:ws2_32> $<$<PLATFORM_ID:Windows>:mswsock>)
