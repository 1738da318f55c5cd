// A checkpoint as a peer's operators' port sends it, over http:// or https://.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>

#include <tl/expected.hpp>

#include "cluster/checkpoint/aside_store.h"
#include "cluster/checkpoint/tar_source.h"

namespace talus::server {

/// What a peer is shown, and by what it is known.
struct PeerAccess {
  std::string token;        // with the right admin; empty: none
  std::string ca;           // PEM: who vouches for peers; empty: the system's authorities
  std::string certificate;  // PEM: this server's; empty: none
  std::string key;          // PEM: the certificate's
  /// A peer that sends less than 16 KiB a second for so long is given up.
  std::chrono::seconds patience{30};
};

/// Why a peer sends none.
struct PeerRefusal {
  std::string reason;  // one line
  bool answers = true;
  std::optional<AsideStore> aside{};  // it has a store, which it must not use
};

class CheckpointDownload final : public TarSource {
 public:
  /// Asks `peer`, "http://HOST:PORT" or "https://HOST:PORT", and waits for the head of its answer. A peer
  /// that is silent is given up as one that sends too little.
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
