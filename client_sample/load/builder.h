// A player that stands in a View and edits, at a rate or as fast as edits are answered, and checks that it
// sees every acknowledged edit of its group.
#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <vector>

#include <talus/edits/editors.h>

#include "edit_site.h"
#include "open_writes.h"
#include "simulated_client.h"

namespace talus::load {

class Builder final : public SimulatedClient {
 public:
  /// `site` is shared by its group.
  Builder(Worker& worker, const ClientProfile& profile, std::shared_ptr<EditSite> site);
  [[nodiscard]] bool satisfied() const override;

 private:
  enum class Attach : std::uint8_t { wanted, sent, done, refused };

  void joined(Time now) override;
  void disconnected(bool lost) override;
  void act_joined(Time now) override;
  [[nodiscard]] Time own_due() const override;
  [[nodiscard]] bool unfinished() const override { return !open_.empty(); }
  void take(const wire::Chunk& chunk) override;
  void take(const wire::UniformColumn& column) override;
  void take(const wire::Unchanged&) override {}
  void take(const wire::Attached& attached) override;
  void take(const wire::EditResult& result) override;
  void take(const wire::EditBroadcast& broadcast) override;
  void take(const wire::Error& error) override;
  void taken_all() override { send_due(Clock::now()); }
  void give_up() override;

  void send_view();
  void send_due(Time now);
  void send_attach();
  void send_write(std::uint64_t sequence);
  void begin_write(Time due);
  [[nodiscard]] bool has_room() const { return open_.size() < unanswered_; }
  void forget(const OpenWrite& write);

  [[nodiscard]] std::optional<std::size_t> part_of(const wire::ChunkKey* key) const;
  /// Records the material observed at `cell`. `update`: the chunk was already held.
  void sees(std::uint32_t cell, MaterialId material, Time now, bool update);
  [[nodiscard]] std::size_t missing() const;

  const std::shared_ptr<EditSite> site_;
  const std::uint32_t place_;     // index in its group
  const Clock::duration period_;  // zero: as fast as edits are answered
  std::size_t next_cell_ = 0;     // in its floor

  OpenWrites open_;
  std::deque<Time> due_;  // edits to be sent that wait for room
  Time next_due_ = Time::max();
  Time hold_until_{};  // as requested by the server

  std::optional<Time> lost_;  // when the connection was lost, until it has attached again
  Attach attach_ = Attach::wanted;
  edits::EditorId editor_;
  std::uint64_t seen_revision_ = 0;
  std::size_t unanswered_ = 1;  // maximum

  std::vector<std::optional<std::uint64_t>> revisions_;  // by the site's parts, as received
  std::vector<std::optional<MaterialId>> seen_;          // by the site's cells
};

}  // namespace talus::load
