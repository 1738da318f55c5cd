// Names of a store's stream and its subjects.
#pragma once

#include <cstdint>
#include <string>

#include <fmt/format.h>

#include <talus/voxel/content_hash.h>

namespace talus::server::jetstream {

struct StreamNames {
  std::string stream;  // "TALUS_<store id>"
  std::string log;     // messages are published here
  std::string tail;    // NATS republishes stored messages here; others must not publish

  /// Subjects on which the leader returns the stream's state, and a message by its number.
  [[nodiscard]] std::string info() const { return "$JS.API.STREAM.INFO." + stream; }
  [[nodiscard]] std::string message_get() const { return "$JS.API.STREAM.MSG.GET." + stream; }
  /// Subject on which any replica returns a message.
  [[nodiscard]] std::string direct_get() const { return "$JS.API.DIRECT.GET." + stream; }

  /// Request texts.
  [[nodiscard]] static std::string by_number(std::uint64_t sequence) {
    return fmt::format("{{\"seq\":{}}}", sequence);
  }
  [[nodiscard]] static std::string with_unused() { return R"({"deleted_details":true})"; }
  [[nodiscard]] static std::string newest_of(const std::string& subject) {
    return fmt::format("{{\"last_by_subj\":\"{}\"}}", subject);
  }

  [[nodiscard]] static StreamNames of(const ContentHash& store_id) {
    const std::string id = to_string(store_id);
    return {fmt::format("TALUS_{}", id), fmt::format("talus.{}.log", id), fmt::format("talus.{}.tail", id)};
  }
};

}  // namespace talus::server::jetstream
