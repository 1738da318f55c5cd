// Messages that were changed on purpose.
#pragma once

#include <xxhash.h>

#include <talus/store/bytes.h>

#include "cluster/message.h"

namespace talus::server::testing {

/// With the checksum that its bytes have by now.
inline store::Bytes sealed_again(store::Bytes message) {
  message.resize(message.size() - cluster::kSealBytes);
  store::ByteWriter{message}.fixed64(XXH3_64bits(message.data(), message.size()));
  return message;
}

/// As a newer talusd may write it.
inline store::Bytes of_newer_format(store::Bytes message) {
  message.at(0) = std::byte{9};
  return sealed_again(std::move(message));
}

}  // namespace talus::server::testing
