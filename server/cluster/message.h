// Messages between the servers of one world in their stream; FORMAT.md specifies every byte. Pure; decodes
// any bytes safely.
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

/// Format of messages, part of kLogFormat. All formats share, and every talusd checks before the format:
/// size, store, world and checksum.
inline constexpr std::uint8_t kMessageFormat = 1;
inline constexpr std::size_t kMaxEntries = 1'024;
/// Maximum size of a message.
inline constexpr std::size_t kMaxMessageBytes = std::size_t{512} << 10U;
/// Maximum size of the first message; smaller, because NATS also counts its publisher's header.
inline constexpr std::size_t kMaxGenesisBytes = kMaxMessageBytes - 1'024;
/// Size of the final checksum.
inline constexpr std::size_t kSealBytes = 8;

/// First message of the stream: the state to which all others are applied.
struct Genesis {
  store::StoreIdentity identity;
  std::uint32_t level_rule = edits::kLevelRule;
  edits::Head head;
  edits::SettleRules settles;    // the world's rules for sliding material
  edits::MaterialIds materials;  // bound names, from kFirstBound on
  bool operator==(const Genesis&) const = default;
};

/// Head of a batch of entries that one server wrote, with its state at that time.
struct BatchHead {
  store::StoreIdentity identity;
  std::uint64_t publisher = 0;  // one start of one server: publisher_of()
  std::uint64_t number = 0;     // batch number from 1 on; the same number means the same batch
  std::int64_t time_ms = 0;     // since 1970, by the server's clock
  std::uint64_t revision = 0;   // of the state after some earlier message
  edits::StateHash hash;        // that state's hash on this server
  bool operator==(const BatchHead&) const = default;
};

/// `start` is a random number drawn at the server's start.
[[nodiscard]] constexpr std::uint64_t publisher_of(std::uint32_t server_number, std::uint32_t start) {
  return std::uint64_t{server_number} << 32U | start;
}
[[nodiscard]] constexpr std::uint32_t server_of(std::uint64_t publisher) {
  return static_cast<std::uint32_t>(publisher >> 32U);
}

struct BatchMessage {
  BatchHead head;
  edits::SettleRulesPtr settles;                    // for entries that settle; null: none does
  std::vector<std::span<const std::byte>> entries;  // views of the message's bytes, to be decoded one by one
};

struct MessageFault {
  enum class Kind : std::uint8_t {
    // Unknown format or kind, which other servers may know if the stream has enabled newer formats
    // (log_format.h).
    newer,
    // Not applicable for any version of talusd, so all skip it.
    damaged,      // wrong checksum, or not written by a talusd
    other_world,  // another fingerprint
    other_store,
  };
  Kind kind = Kind::damaged;
  std::string reason;  // one line; remedy_of() completes some
};

/// Remedy to append to the reason of a message that stops this talusd: "; upgrade it", or empty if the reason
/// includes it.
[[nodiscard]] std::string_view remedy_of(const MessageFault& fault);

/// Hash by which a store remembers its last applied message, of any kind.
[[nodiscard]] std::uint64_t hash_of_message(std::span<const std::byte> bytes);

/// An error is one line: more materials than fit into a message.
[[nodiscard]] tl::expected<store::Bytes, std::string> encode(const Genesis& genesis);
[[nodiscard]] tl::expected<Genesis, MessageFault> decode_genesis(std::span<const std::byte> bytes);

/// Maximum overhead of a batch with the rules `settles`, in bytes.
[[nodiscard]] std::size_t batch_overhead(const edits::SettleRulesPtr& settles);

/// Encodes a batch of entries encoded by entry_codec.h. REQUIRES: at most kMaxEntries and kMaxMessageBytes in
/// total (asserted).
[[nodiscard]] store::Bytes encode_batch(const BatchHead& head, const edits::SettleRulesPtr& settles,
                                        std::span<const store::Bytes> entries);
/// Classifies a batch whose entry `first` is the first that decode_entry() rejects: `newer` if any entry is,
/// because a newer talusd may accept them all; otherwise `damaged`.
[[nodiscard]] MessageFault fault_of_entries(const BatchMessage& batch, std::size_t first);

/// Why a server with this store and world does not apply the message, as reported by decode_batch() and
/// fault_of_entries(); nullopt if it does. `sequence` 1 is a genesis.
[[nodiscard]] std::optional<MessageFault> fault_of(std::span<const std::byte> bytes, std::uint64_t sequence,
                                                   const store::StoreIdentity& identity);

/// Decodes a batch of this world and store. The result refers to `bytes`.
[[nodiscard]] tl::expected<BatchMessage, MessageFault> decode_batch(std::span<const std::byte> bytes,
                                                                    const store::StoreIdentity& identity);

}  // namespace talus::server::cluster
