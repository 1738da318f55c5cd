// What a store's stream and its subjects are called.
#pragma once

#include <cstdint>
#include <string>

#include <fmt/format.h>

#include <talus/voxel/content_hash.h>

namespace talus::server::jetstream {

struct StreamNames {
  std::string stream;  // "TALUS_<store id>"
  std::string log;     // messages are published to it
  std::string tail;    // NATS publishes them to it, once they are stored; nobody else may

  /// Where its leader says what it is, and gives a message by its number.
  [[nodiscard]] std::string info() const { return "$JS.API.STREAM.INFO." + stream; }
  [[nodiscard]] std::string message_get() const { return "$JS.API.STREAM.MSG.GET." + stream; }
  /// Where any replica does.
  [[nodiscard]] std::string direct_get() const { return "$JS.API.DIRECT.GET." + stream; }

  /// What is asked there.
  [[nodiscard]] static std::string by_number(std::uint64_t sequence) {
    return fmt::format("{{\"seq\":{}}}", sequence);
  }
  [[nodiscard]] static std::string newest_of(const std::string& subject) {
    return fmt::format("{{\"last_by_subj\":\"{}\"}}", subject);
  }

  [[nodiscard]] static StreamNames of(const ContentHash& store_id) {
    const std::string id = to_string(store_id);
    return {fmt::format("TALUS_{}", id), fmt::format("talus.{}.log", id), fmt::format("talus.{}.tail", id)};
  }
};

}  // namespace talus::server::jetstream
