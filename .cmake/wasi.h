// Included before every source for WebAssembly: Debian's libc++ for it leaves out file streams, which work.
#pragma once

#include <version>

#undef _LIBCPP_HAS_NO_FILESYSTEM
#undef _LIBCPP_AVAILABILITY_HAS_ADDITIONAL_IOSTREAM_EXPLICIT_INSTANTIATIONS_1
#define _LIBCPP_AVAILABILITY_HAS_ADDITIONAL_IOSTREAM_EXPLICIT_INSTANTIATIONS_1 0
