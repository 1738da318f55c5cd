# The libraries that the generator needs, from the headers of this machine's packages, which are the same for every machine:
# for targets that have no such packages.
set(headers ${CMAKE_BINARY_DIR}/headers)
file(MAKE_DIRECTORY ${headers})
foreach(header glm hwy tl toml++ xxhash.h)
  if(NOT EXISTS /usr/include/${header})
    message(FATAL_ERROR "/usr/include/${header} is missing: ./dev deps build installs it")
  endif()
  file(CREATE_LINK /usr/include/${header} ${headers}/${header} SYMBOLIC)
endforeach()
foreach(library tl::expected tomlplusplus::tomlplusplus PkgConfig::highway PkgConfig::xxhash)
  add_library(${library} INTERFACE IMPORTED GLOBAL)
  target_include_directories(${library} SYSTEM INTERFACE ${headers})
endforeach()
target_compile_definitions(tomlplusplus::tomlplusplus INTERFACE TOML_HEADER_ONLY=1)
target_compile_definitions(PkgConfig::xxhash INTERFACE XXH_INLINE_ALL)
# g++ 12 sees a copy before the buffer of XXH3_update(), which it inlines.
target_compile_options(PkgConfig::xxhash INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds>)
