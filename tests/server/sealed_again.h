// Messages that were changed on purpose.
#pragma once

#include <xxhash.h>

#include "cluster/message.h"
#include "store/bytes.h"

namespace talus::server::testing {

/// With the checksum that its bytes have by now.
inline Bytes sealed_again(Bytes message) {
  message.resize(message.size() - cluster::kSealBytes);
  ByteWriter{message}.fixed64(XXH3_64bits(message.data(), message.size()));
  return message;
}

/// As a newer talusd may write it.
inline Bytes of_newer_format(Bytes message) {
  message.at(0) = std::byte{9};
  return sealed_again(std::move(message));
}

}  // namespace talus::server::testing
