// What the servers of one world write to each other into their stream: FORMAT.md has every byte. Pure; any
// bytes are safe to decode.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include <talus/edits/batch.h>
#include <talus/edits/settle.h>
#include <talus/store/records.h>
#include <talus/store/store_identity.h>
#include <talus/voxel/content_hash.h>

namespace talus::server::cluster {

/// Of messages: part of kLogFormat. What every format has alike, and every talusd checks before it looks at
/// the format: the size, the store, the world and the checksum.
inline constexpr std::uint8_t kMessageFormat = 1;
inline constexpr std::size_t kMaxEntries = 1'024;
/// Of one message.
inline constexpr std::size_t kMaxMessageBytes = std::size_t{512} << 10U;
/// Of the first one, as NATS counts a header of its publisher too.
inline constexpr std::size_t kMaxGenesisBytes = kMaxMessageBytes - 1'024;
/// Of the checksum at its end.
inline constexpr std::size_t kSealBytes = 8;

/// The stream's first message: the state on which all others are applied.
struct Genesis {
  store::StoreIdentity identity;
  std::uint32_t level_rule = edits::kLevelRule;
  edits::Head head;
  edits::SettleRules settles;    // by which loose material slides in this world
  edits::MaterialIds materials;  // that are bound: from kFirstBound on
  bool operator==(const Genesis&) const = default;
};

/// Entries that one server wrote at once, and where it stood when it did.
struct BatchHead {
  store::StoreIdentity identity;
  std::uint64_t publisher = 0;  // of one start of one server: publisher_of()
  std::uint64_t number = 0;     // of its batches: from 1 on. The same number again is the same batch again
  std::int64_t time_ms = 0;     // since 1970, by the server's clock
  std::uint64_t revision = 0;   // of the state at the end of some message before this one
  edits::StateHash hash;        // of that state, as the server has it
  bool operator==(const BatchHead&) const = default;
};

/// `start`: drawn when the server started.
[[nodiscard]] constexpr std::uint64_t publisher_of(std::uint32_t server_number, std::uint32_t start) {
  return std::uint64_t{server_number} << 32U | start;
}
[[nodiscard]] constexpr std::uint32_t server_of(std::uint64_t publisher) {
  return static_cast<std::uint32_t>(publisher >> 32U);
}

struct BatchMessage {
  BatchHead head;
  edits::SettleRulesPtr settles;                    // of those entries that settle; null: none does
  std::vector<std::span<const std::byte>> entries;  // of the message's bytes, to be decoded one by one
};

struct MessageFault {
  enum class Kind : std::uint8_t {
    // Its format or kind is one that this talusd does not know, and others may, where the stream has enabled
    // such (log_format.h).
    newer,
    // No talusd of whatever version applies it, so all pass over it.
    damaged,      // its checksum is wrong, or no talusd wrote it
    other_world,  // it is of another fingerprint
    other_store,
  };
  Kind kind = Kind::damaged;
  std::string reason;  // one line: what is wrong; what would be right, remedy_of() says of some
};

/// What would be right, to go behind the reason: "; upgrade it", or nothing where the reason says it. Of a
/// message that stops this talusd.
[[nodiscard]] std::string_view remedy_of(const MessageFault& fault);

/// By which a store remembers the message that it applied last, whatever that is.
[[nodiscard]] std::uint64_t hash_of_message(std::span<const std::byte> bytes);

/// An error, in one line, where it has more materials than a message holds.
[[nodiscard]] tl::expected<store::Bytes, std::string> encode(const Genesis& genesis);
[[nodiscard]] tl::expected<Genesis, MessageFault> decode_genesis(std::span<const std::byte> bytes);

/// Bytes that a batch has beside its entries, at most, where `settles` are its rules.
[[nodiscard]] std::size_t batch_overhead(const edits::SettleRulesPtr& settles);

/// Of entries as encode() of entry_codec.h writes them. REQUIRES: at most kMaxEntries and kMaxMessageBytes in
/// all (asserted).
[[nodiscard]] store::Bytes encode_batch(const BatchHead& head, const edits::SettleRulesPtr& settles,
                                        std::span<const store::Bytes> entries);
/// What becomes of a batch whose entry number `first` is the first that decode_entry() refuses: `newer` where
/// any of its entries is, as a talusd that knows it may find all of them right; else `damaged`.
[[nodiscard]] MessageFault fault_of_entries(const BatchMessage& batch, std::size_t first);

/// Why a server with this store and world does not apply the message, if it does not: as decode_batch() and
/// fault_of_entries() say it. `sequence` 1 is a genesis.
[[nodiscard]] std::optional<MessageFault> fault_of(std::span<const std::byte> bytes, std::uint64_t sequence,
                                                   const store::StoreIdentity& identity);

/// A batch of this world and store. What is returned refers to `bytes`.
[[nodiscard]] tl::expected<BatchMessage, MessageFault> decode_batch(std::span<const std::byte> bytes,
                                                                    const store::StoreIdentity& identity);

}  // namespace talus::server::cluster
