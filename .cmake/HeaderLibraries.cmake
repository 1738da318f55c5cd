# The libraries that are headers alone, of this machine's packages, which are the same for every machine: for targets that have
# no such packages.
set(headers ${CMAKE_BINARY_DIR}/headers)
file(MAKE_DIRECTORY ${headers})
set(needed glm hwy tl toml++ xxhash.h)
if(NOT TALUS_ONLY_GOLDEN)
  list(APPEND needed asio asio.hpp CLI flatbuffers nlohmann)
endif()
foreach(header IN LISTS needed)
  if(NOT EXISTS /usr/include/${header})
    message(FATAL_ERROR "/usr/include/${header} is missing: ./dev deps build installs it")
  endif()
  file(CREATE_LINK /usr/include/${header} ${headers}/${header} SYMBOLIC)
endforeach()
if(TALUS_WASM)  # for which Highway 1.0.3 looks bytes up one by one, and leaves the instruction out
  set(operations hwy/ops/wasm_128-inl.h)
  file(READ /usr/include/${operations} text)
  if(NOT text MATCHES "#if 0\n  return Vec128<TI, NI>{wasm_i8x16_swizzle")
    message(FATAL_ERROR "/usr/include/${operations} is not Highway 1.0.3's: see how it looks bytes up, by wasm_i8x16_swizzle() or not")
  endif()
  string(REPLACE "#if 0\n  return Vec128<TI, NI>{wasm_i8x16_swizzle(" "#if 1\n  return Vec128<TI, NI>{wasm_i8x16_swizzle("
    text "${text}")
  file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/changed_headers/${operations} CONTENT "${text}" @ONLY)
  include_directories(SYSTEM ${CMAKE_BINARY_DIR}/changed_headers)
endif()
include_directories(SYSTEM ${headers})
foreach(library tl::expected tomlplusplus::tomlplusplus PkgConfig::highway PkgConfig::xxhash CLI11::CLI11
    nlohmann_json::nlohmann_json flatbuffers)
  add_library(${library} INTERFACE IMPORTED GLOBAL)
endforeach()
foreach(package cli11 nlohmann_json)  # what find_package() finds
  file(WRITE ${CMAKE_FIND_PACKAGE_REDIRECTS_DIR}/${package}-config.cmake "")
endforeach()
target_compile_definitions(tomlplusplus::tomlplusplus INTERFACE TOML_HEADER_ONLY=1
  $<$<BOOL:${TALUS_WASM}>:TOML_FLOAT_CHARCONV=1>)  # by .cmake/wasi.h
target_compile_definitions(PkgConfig::xxhash INTERFACE XXH_INLINE_ALL)
# g++ 12 sees a copy before the buffer of XXH3_update(), which it inlines.
target_compile_options(PkgConfig::xxhash INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds>)
