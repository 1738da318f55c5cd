#include "cluster/message.h"

#include <cassert>
#include <memory>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <xxhash.h>

#include <talus/store/bytes.h>

#include "cluster/entry_codec.h"

namespace talus::server::cluster {
namespace {

enum class MessageKind : std::uint8_t { genesis, batch };

// Fingerprint, id, publisher, number, time, revision and state hash, with overhead.
constexpr std::size_t kBatchFixedBytes = 128;
// Longest varint, also used before an entry.
constexpr std::size_t kLongestNumber = 10;
// Format, kind, store, fingerprint and checksum.
constexpr std::size_t kFrameBytes = 2 + 32 + kSealBytes;

void put_identity(const store::StoreIdentity& identity, store::ByteWriter& out) {
  for (const ContentHash hash : {identity.store_id, identity.fingerprint}) {
    out.fixed64(hash.low);
    out.fixed64(hash.high);
  }
}
store::StoreIdentity get_identity(store::ByteReader& in) {
  store::StoreIdentity identity;
  for (ContentHash* const hash : {&identity.store_id, &identity.fingerprint}) {
    hash->low = in.fixed64();
    hash->high = in.fixed64();
  }
  return identity;
}

void put_rules(const edits::SettleRules& rules, store::ByteWriter& out) {
  out.varint(rules.size());
  for (const edits::SettleRule& rule : rules) {
    out.varint(to_integer(rule.material));
    out.zigzag(rule.rise);
  }
}
edits::SettleRules get_rules(store::ByteReader& in) {
  edits::SettleRules rules;
  for (std::size_t left = in.count(); left > 0 && in.ok(); --left) {
    const MaterialId material{static_cast<std::uint16_t>(in.varint(UINT16_MAX))};
    const auto rise = static_cast<std::int32_t>(in.zigzag(UINT32_MAX));
    if (!rules.empty() && rules.back().material >= material) in.fail();
    rules.push_back({material, rise});
  }
  return rules;
}

void put_state(std::uint64_t revision, edits::StateHash hash, store::ByteWriter& out) {
  out.fixed64(revision);
  out.fixed64(hash.low);
  out.fixed64(hash.high);
}

store::Bytes begin_message(MessageKind kind) {
  store::Bytes out;
  store::ByteWriter writer{out};
  writer.byte(kMessageFormat);
  writer.byte(static_cast<std::uint8_t>(kind));
  return out;
}

void seal_message(store::Bytes& out) {
  store::ByteWriter{out}.fixed64(XXH3_64bits(out.data(), out.size()));
}

tl::unexpected<MessageFault> message_fault(MessageFault::Kind kind, std::string reason) {
  return tl::unexpected{MessageFault{kind, std::move(reason)}};
}

tl::unexpected<MessageFault> damaged(std::string_view what) {
  return message_fault(MessageFault::Kind::damaged, std::string{what});
}

/// Returns a message without its checksum. Checks only what all formats share, to distinguish foreign
/// messages from a newer talusd's.
tl::expected<std::span<const std::byte>, MessageFault> open_frame(std::span<const std::byte> bytes) {
  if (bytes.empty()) return damaged("it is empty");
  if (bytes.size() > kMaxMessageBytes) {
    return damaged(fmt::format("it has {} bytes; {} is the most", bytes.size(), kMaxMessageBytes));
  }
  if (bytes.size() < kFrameBytes || bytes.front() == std::byte{0}) {
    return damaged("it was not written by a talusd");
  }
  const auto body = bytes.first(bytes.size() - kSealBytes);
  if (store::ByteReader{bytes.last(kSealBytes)}.fixed64() != XXH3_64bits(body.data(), body.size())) {
    return damaged("its checksum is wrong");
  }
  return body;
}

tl::expected<void, MessageFault> check_identity(const store::StoreIdentity& held,
                                                const store::StoreIdentity& identity) {
  if (held.store_id != identity.store_id) {
    return message_fault(MessageFault::Kind::other_store,
                         fmt::format("it is of store {}; this server has store {}", to_string(held.store_id),
                                     to_string(identity.store_id)));
  }
  if (held.fingerprint != identity.fingerprint) {
    return message_fault(
        MessageFault::Kind::other_world,
        fmt::format("it is of the world with fingerprint {}; this server's world has {}; all servers of a "
                    "store must have the same world and secret.key_file",
                    to_string(held.fingerprint), to_string(identity.fingerprint)));
  }
  return {};
}

/// Returns the part between kind and checksum. `identity` is the required store and world.
tl::expected<std::span<const std::byte>, MessageFault> open_message(std::span<const std::byte> bytes,
                                                                    MessageKind kind,
                                                                    const store::StoreIdentity* identity) {
  const auto frame = open_frame(bytes);
  if (!frame) return frame;
  const auto body = frame->subspan(2);
  if (identity != nullptr) {
    store::ByteReader in{body};
    if (auto ours = check_identity(get_identity(in), *identity); !ours) return tl::unexpected{ours.error()};
  }
  const auto format = std::to_integer<std::uint8_t>(frame->front());
  if (format > kMessageFormat) {
    return message_fault(MessageFault::Kind::newer,
                         fmt::format("it has format {}; this talusd reads up to {}", format, kMessageFormat));
  }
  const auto held = std::to_integer<std::uint8_t>((*frame)[1]);
  if (held == static_cast<std::uint8_t>(kind)) return body;
  if (held > static_cast<std::uint8_t>(MessageKind::batch)) {
    return message_fault(MessageFault::Kind::newer,
                         fmt::format("it is of kind {}, which this talusd does not know", held));
  }
  return damaged(kind == MessageKind::batch ? "it is a genesis; there is one, and it comes first"
                                            : "it is not a genesis; the first message must be one");
}

}  // namespace

std::string_view remedy_of(const MessageFault& fault) {
  return fault.kind == MessageFault::Kind::newer ? "; upgrade it" : "";
}

std::uint64_t hash_of_message(std::span<const std::byte> bytes) {
  return XXH3_64bits(bytes.data(), bytes.size());
}

tl::expected<store::Bytes, std::string> encode(const Genesis& genesis) {
  store::Bytes out = begin_message(MessageKind::genesis);
  store::ByteWriter writer{out};
  put_identity(genesis.identity, writer);
  writer.fixed32(genesis.level_rule);
  writer.fixed64(genesis.head.position);
  writer.fixed64(static_cast<std::uint64_t>(genesis.head.time_ms));
  put_state(genesis.head.revision, genesis.head.hash, writer);
  put_rules(genesis.settles, writer);
  writer.varint(genesis.materials.size());
  for (const auto& [name, id] : genesis.materials) {
    writer.counted(name);
    writer.varint(to_integer(id));
  }
  seal_message(out);
  if (out.size() > kMaxGenesisBytes) {
    return tl::unexpected{
        fmt::format("the store has {} materials, which make {} bytes; the first message has at "
                    "most {}; a store of fewer materials is needed",
                    genesis.materials.size(), out.size(), kMaxGenesisBytes)};
  }
  return out;
}

tl::expected<Genesis, MessageFault> decode_genesis(std::span<const std::byte> bytes) {
  const auto body = open_message(bytes, MessageKind::genesis, nullptr);
  if (!body) return tl::unexpected{body.error()};
  store::ByteReader in{*body};
  Genesis genesis;
  genesis.identity = get_identity(in);
  genesis.level_rule = in.fixed32();
  genesis.head.position = in.fixed64();
  genesis.head.time_ms = static_cast<std::int64_t>(in.fixed64());
  genesis.head.revision = in.fixed64();
  genesis.head.hash.low = in.fixed64();
  genesis.head.hash.high = in.fixed64();
  genesis.settles = get_rules(in);
  for (std::size_t left = in.count(); left > 0 && in.ok(); --left) {
    std::string name = in.text(edits::kMaxMaterialNameBytes);
    const auto id = static_cast<std::uint16_t>(in.varint(UINT16_MAX));
    const bool rises = genesis.materials.empty() || genesis.materials.rbegin()->first < name;
    if (id < edits::kFirstBound || name.empty() || !rises) in.fail();
    genesis.materials.emplace_hint(genesis.materials.end(), std::move(name), MaterialId{id});
  }
  if (!in.ended()) return damaged("its fields are damaged");
  return genesis;
}

std::size_t batch_overhead(const edits::SettleRulesPtr& settles) {
  return kBatchFixedBytes + (settles == nullptr ? 0 : settles->size() * 2 * kLongestNumber);
}

store::Bytes encode_batch(const BatchHead& head, const edits::SettleRulesPtr& settles,
                          std::span<const store::Bytes> entries) {
  assert(entries.size() <= kMaxEntries);
  store::Bytes out = begin_message(MessageKind::batch);
  store::ByteWriter writer{out};
  put_identity(head.identity, writer);
  writer.fixed64(head.publisher);
  writer.varint(head.number);
  writer.varint(static_cast<std::uint64_t>(head.time_ms));
  put_state(head.revision, head.hash, writer);
  writer.byte(settles == nullptr ? 0 : 1);
  if (settles != nullptr) put_rules(*settles, writer);
  writer.varint(entries.size());
  for (const store::Bytes& entry : entries) writer.counted(entry);
  seal_message(out);
  assert(out.size() <= kMaxMessageBytes);
  return out;
}

tl::expected<BatchMessage, MessageFault> decode_batch(std::span<const std::byte> bytes,
                                                      const store::StoreIdentity& identity) {
  const auto body = open_message(bytes, MessageKind::batch, &identity);
  if (!body) return tl::unexpected{body.error()};
  store::ByteReader in{*body};
  BatchMessage batch;
  batch.head.identity = get_identity(in);
  batch.head.publisher = in.fixed64();
  batch.head.number = in.varint();
  batch.head.time_ms = static_cast<std::int64_t>(in.varint(INT64_MAX));
  batch.head.revision = in.fixed64();
  batch.head.hash.low = in.fixed64();
  batch.head.hash.high = in.fixed64();
  const std::uint8_t has_rules = in.byte();
  if (has_rules > 1) in.fail();
  if (has_rules == 1) batch.settles = std::make_shared<const edits::SettleRules>(get_rules(in));
  const std::uint64_t count = in.varint(kMaxEntries);
  for (std::uint64_t i = 0; i < count && in.ok(); ++i) batch.entries.push_back(in.counted());
  if (!in.ended()) return damaged("its fields are damaged");
  return batch;
}

MessageFault fault_of_entries(const BatchMessage& batch, std::size_t first) {
  for (std::size_t i = first; i < batch.entries.size(); ++i) {
    const auto entry = decode_entry(batch.entries[i], batch.settles);
    if (entry || entry.error() != EntryFault::newer) continue;
    return {MessageFault::Kind::newer,
            fmt::format("its entry {} is one that this talusd does not know", i + 1)};
  }
  return {MessageFault::Kind::damaged, fmt::format("its entry {} is damaged", first + 1)};
}

std::optional<MessageFault> fault_of(std::span<const std::byte> bytes, std::uint64_t sequence,
                                     const store::StoreIdentity& identity) {
  if (sequence == 1) {
    const auto genesis = decode_genesis(bytes);
    if (!genesis) return genesis.error();
    const auto ours = check_identity(genesis->identity, identity);
    return ours ? std::nullopt : std::optional{ours.error()};
  }
  const auto batch = decode_batch(bytes, identity);
  if (!batch) return batch.error();
  for (std::size_t i = 0; i < batch->entries.size(); ++i) {
    if (!decode_entry(batch->entries[i], batch->settles)) return fault_of_entries(*batch, i);
  }
  return std::nullopt;
}

}  // namespace talus::server::cluster
