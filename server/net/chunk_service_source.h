// ChunkService as a ChunkSource. Stands until BaseChunks is that source itself.
#pragma once

#include <memory>
#include <mutex>
#include <unordered_map>
#include <utility>
#include <vector>

#include "chunks/chunk_source.h"
#include "generation/chunk_service.h"

namespace talus::server {

class ChunkServiceSource final : public ChunkSource {
 public:
  explicit ChunkServiceSource(ChunkService& service) : service_{service} {}

  [[nodiscard]] EncodedChunkPtr find(ChunkKey key) override { return service_.find(key); }
  [[nodiscard]] EncodedChunkPtr newer(ChunkKey, std::uint64_t) override { return nullptr; }
  [[nodiscard]] MixedRows column(ChunkKey key) override {
    const auto rows = service_.rows(key);
    return {rows.first, rows.last, rows.below};
  }
  [[nodiscard]] Submission submit(const MailboxPtr& mailbox, ChunkKey key) override {
    if (service_.submit(client_of(mailbox), key) == ChunkService::Submission::queued) {
      return Submission::queued;
    }
    const std::lock_guard lock{mutex_};
    refused_.push_back(mailbox);
    return Submission::refused;
  }
  void cancel(ClientId client, ChunkKey key) override {
    if (const ChunkClientPtr known = client_of(client)) service_.cancel(*known, key);
  }
  void submit_heights(const MailboxPtr& mailbox, std::uint64_t ticket,
                      std::vector<terrain::BaseColumn> columns) override {
    service_.submit_heights({client_of(mailbox), ticket, std::move(columns)});
  }
  void cancel_heights(ClientId client, std::uint64_t ticket) override {
    if (const ChunkClientPtr known = client_of(client)) service_.cancel_heights(*known, ticket);
  }

  /// Tells those who were refused to try again. Call it now and then.
  void tell_of_room() {
    std::vector<std::weak_ptr<Mailbox>> refused;
    {
      const std::lock_guard lock{mutex_};
      refused.swap(refused_);
      std::erase_if(clients_, [](const auto& each) { return each.second->mailbox.expired(); });
    }
    for (const auto& each : refused) {
      const MailboxPtr mailbox = each.lock();
      if (mailbox == nullptr) continue;
      mailbox->put(QueueHasRoom{});
      mailbox->wake();
    }
  }

 private:
  struct Client final : ChunkClient {
    explicit Client(std::weak_ptr<Mailbox> owner) : mailbox{std::move(owner)} {}
    void chunks_ready(std::vector<ReadyChunk> chunks) override {
      const MailboxPtr owner = mailbox.lock();
      if (owner == nullptr) return;
      for (ReadyChunk& chunk : chunks) owner->put(ChunkReady{chunk.key, std::move(chunk.answer)});
      owner->wake();
    }
    void heights_ready(std::uint64_t ticket, HeightsAnswer answer) override {
      const MailboxPtr owner = mailbox.lock();
      if (owner == nullptr) return;
      owner->put(HeightsReady{ticket, std::move(answer)});
      owner->wake();
    }
    std::weak_ptr<Mailbox> mailbox;
  };

  ChunkClientPtr client_of(const MailboxPtr& mailbox) {
    const std::lock_guard lock{mutex_};
    auto& client = clients_[mailbox->owner()];
    if (client == nullptr) client = std::make_shared<Client>(mailbox);
    return client;
  }
  ChunkClientPtr client_of(ClientId id) {
    const std::lock_guard lock{mutex_};
    const auto found = clients_.find(id);
    return found == clients_.end() ? nullptr : found->second;
  }

  ChunkService& service_;
  std::mutex mutex_;
  std::unordered_map<ClientId, std::shared_ptr<Client>> clients_;
  std::vector<std::weak_ptr<Mailbox>> refused_;
};

}  // namespace talus::server
