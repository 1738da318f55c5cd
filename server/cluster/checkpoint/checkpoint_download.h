// Downloads a checkpoint from a peer's operators' port by http:// or https://.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>

#include <tl/expected.hpp>

#include "cluster/checkpoint/aside_store.h"
#include "cluster/checkpoint/tar_source.h"

namespace talus::server {

/// Credentials for a peer, and the means to verify it.
struct PeerAccess {
  std::string token;        // with the right admin; may be empty
  std::string ca;           // PEM: authorities of peers; empty: the system's
  std::string certificate;  // PEM: this server's; may be empty
  std::string key;          // PEM: key of the certificate
  /// A peer that sends less than 16 KiB per second for this time is abandoned.
  std::chrono::seconds patience{30};
};

/// Reason why a peer does not send a checkpoint.
struct PeerRefusal {
  std::string reason;  // one line
  bool answers = true;
  std::optional<AsideStore> aside{};  // its store, if it must not use it
};

class CheckpointDownload final : public TarSource {
 public:
  /// Sends the request to `peer`, "http://HOST:PORT" or "https://HOST:PORT", and waits for the head of the
  /// answer. A silent peer is abandoned like a slow one.
  [[nodiscard]] static tl::expected<std::unique_ptr<CheckpointDownload>, PeerRefusal> open(
      const std::string& peer, const PeerAccess& access);
  ~CheckpointDownload() override;

  [[nodiscard]] std::uint64_t size() const override;
  [[nodiscard]] tl::expected<std::string_view, std::string> read() override;

 private:
  class Transfer;
  explicit CheckpointDownload(std::unique_ptr<Transfer> transfer);

  std::unique_ptr<Transfer> transfer_;
};

}  // namespace talus::server
