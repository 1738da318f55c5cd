// Any bytes given as messages and entries of the log that servers share: refused, or what would be written
// as these very bytes. The checksum is made right first, as no mutation would find it.
#include <cstdlib>
#include <iostream>
#include <memory>
#include <string_view>
#include <vector>

#include <xxhash.h>

#include "cluster/entry_codec.h"
#include "cluster/message.h"

namespace {

using namespace talus;
using namespace talus::server;

void require(bool holds, std::string_view what) {
  if (holds) return;
  std::cerr << "decode_cluster: " << what << '\n';
  std::abort();
}

const edits::SettleRulesPtr& rules() {
  static const auto made =
      std::make_shared<const edits::SettleRules>(edits::SettleRules{{MaterialId{3}, 256}});
  return made;
}

void try_entry(std::span<const std::byte> bytes, const edits::SettleRulesPtr& settles) {
  const auto entry = cluster::decode_entry(bytes, settles);
  if (!entry) return;
  store::Bytes again;
  cluster::encode(*entry, again);
  const auto* const edit = std::get_if<edits::EditEntry>(&*entry);
  if (edit != nullptr && edit->edit.paste) {  // a chunk may have had an older codec's bytes
    const auto second = cluster::decode_entry(again, settles);
    require(second.has_value(), "what was written is read");
    store::Bytes third;
    cluster::encode(*second, third);
    require(third == again, "an entry that was written has one encoding");
  } else {
    require(std::equal(again.begin(), again.end(), bytes.begin(), bytes.end()), "an entry has one encoding");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto* const first = reinterpret_cast<const std::byte*>(data);
  const std::span<const std::byte> raw{first, size};
  try_entry(raw, rules());

  store::Bytes message(raw.begin(), raw.end());
  const std::uint64_t hash = XXH3_64bits(message.data(), message.size());
  for (int i = 0; i < 8; ++i) message.push_back(static_cast<std::byte>(hash >> (8 * i)));
  if (const auto genesis = cluster::decode_genesis(message)) {
    const auto again = cluster::encode(*genesis);
    require(again && *again == message, "a genesis has one encoding");
  }
  if (message.size() >= 34) {
    store::StoreIdentity identity;  // its own
    const auto number = [&](std::size_t at) {
      std::uint64_t value = 0;
      for (std::size_t i = 8; i > 0; --i)
        value = value << 8 | std::to_integer<std::uint64_t>(message[at + i - 1]);
      return value;
    };
    identity.store_id = {number(2), number(10)};
    identity.fingerprint = {number(18), number(26)};
    if (const auto batch = cluster::decode_batch(message, identity)) {
      std::vector<store::Bytes> entries;
      for (const auto entry : batch->entries) {
        entries.emplace_back(entry.begin(), entry.end());
        try_entry(entry, batch->settles);
      }
      require(cluster::encode_batch(batch->head, batch->settles, entries) == message,
              "a batch has one encoding");
    }
  }
  return 0;
}
