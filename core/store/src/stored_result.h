// The result of an edit, as encoded in log records and editors.
#pragma once

#include <cstdint>

#include <talus/edits/editors.h>
#include <talus/store/bytes.h>

namespace talus::store {

inline void put_result(const edits::EditResult& result, ByteWriter& out) {
  out.varint(result.sequence);
  out.varint(result.revision);
  out.varint(result.changed);
  out.varint(result.conflict ? std::uint64_t{*result.conflict} + 1 : 0);
}
inline edits::EditResult get_result(ByteReader& in) {
  edits::EditResult result;
  result.sequence = in.varint();
  result.revision = in.varint();
  result.changed = static_cast<std::uint32_t>(in.varint(UINT32_MAX));
  const std::uint64_t conflict = in.varint(std::uint64_t{UINT32_MAX} + 1);
  if (conflict > 0) result.conflict = static_cast<std::uint32_t>(conflict - 1);
  return result;
}

}  // namespace talus::store
