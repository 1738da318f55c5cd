// Why a save cannot be used.
#pragma once

#include <cstdint>
#include <string>

#include <tl/expected.hpp>

namespace talus::saves {

struct SaveError {
  enum class Kind : std::uint8_t {
    missing,    // no such file, or it may not be read
    exists,     // create(): the file is there already
    in_use,     // by a program, perhaps this one
    read_only,  // the file, or how it was opened
    foreign,    // no save of Talus
    other,      // of another format, generator version or fingerprint
    damaged,    // not as it was written
    full,       // the disk is full
    disk,       // it cannot be read or written
  };
  Kind kind = Kind::disk;
  std::string message;  // one line: the file, the fault, and what is expected
};

template <typename T>
using Result = tl::expected<T, SaveError>;

}  // namespace talus::saves
