# Cross-compiles libtalus for Windows from Debian (g++-mingw-w64-x86-64-posix). TALUS_WINDOWS_PREFIX: a folder with include/
# and lib/ of Asio, FlatBuffers, glm, Highway, tl::expected and xxHash, built by the same compiler.
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR x86_64)
set(CMAKE_C_COMPILER x86_64-w64-mingw32-gcc-posix)
set(CMAKE_CXX_COMPILER x86_64-w64-mingw32-g++-posix)
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES TALUS_WINDOWS_PREFIX)
set(CMAKE_FIND_ROOT_PATH ${TALUS_WINDOWS_PREFIX})
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)  # flatc runs here
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
set(CMAKE_CXX_FLAGS_INIT "-isystem ${TALUS_WINDOWS_PREFIX}/include")
set(CMAKE_SHARED_LINKER_FLAGS_INIT -L${TALUS_WINDOWS_PREFIX}/lib)
set(ENV{PKG_CONFIG_LIBDIR} ${TALUS_WINDOWS_PREFIX}/lib/pkgconfig)
