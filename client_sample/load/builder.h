// A player who stands in a View and edits, at a rate or as fast as it is answered, and looks whether it sees
// all that its group was told is stored.
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
  /// `site` is its group's.
  Builder(Worker& worker, const ClientProfile& profile, std::shared_ptr<EditSite> site);
  [[nodiscard]] bool satisfied() const override;

 private:
  enum class Attach : std::uint8_t { wanted, sent, done, refused };

  void joined(Time now) override;
  void disconnected(bool lost) override;
  void act_joined(Time now) override;
  [[nodiscard]] Time own_due() const override;
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
  /// It sees this there; `update`: the chunk was here, and has changed.
  void sees(std::uint32_t cell, MaterialId material, Time now, bool update);
  [[nodiscard]] std::size_t missing() const;

  const std::shared_ptr<EditSite> site_;
  const std::uint32_t place_;     // in its group
  const Clock::duration period_;  // zero: as fast as it is answered
  std::size_t next_cell_ = 0;     // of its floor

  OpenWrites open_;
  std::deque<Time> due_;  // edits that are to be sent, and wait for room
  Time next_due_ = Time::max();
  Time hold_until_{};  // as the server asked

  std::optional<Time> lost_;  // when its connection was, where it is not attached again
  Attach attach_ = Attach::wanted;
  edits::EditorId editor_;
  std::uint64_t seen_revision_ = 0;
  std::size_t unanswered_ = 1;  // at most

  std::vector<std::optional<std::uint64_t>> revisions_;  // of the site's parts, as they came
  std::vector<std::optional<MaterialId>> seen_;          // of the site's cells
};

}  // namespace talus::load
