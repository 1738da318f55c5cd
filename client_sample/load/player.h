// A client with a View: walks, flies or stands, and checks the chunks that arrive for it.
#pragma once

#include <memory>
#include <optional>
#include <span>

#include "held_revisions.h"
#include "movement.h"
#include "near_waits.h"
#include "pending_chunks.h"
#include "pending_rings.h"
#include "proofs.h"
#include "simulated_client.h"

namespace talus::load {

class Player final : public SimulatedClient {
 public:
  Player(Worker& worker, const ClientProfile& profile);
  [[nodiscard]] bool satisfied() const override;

 private:
  void joined(Time now) override;
  void disconnected(bool lost) override;
  void act_joined(Time now) override;
  [[nodiscard]] Time own_due() const override { return tick_due_; }
  void take(const wire::Chunk& chunk) override;
  void take(const wire::UniformColumn& column) override;
  void take(const wire::Unchanged& unchanged) override;
  void take(const wire::EditBroadcast& broadcast) override;
  void take(const wire::ViewComplete& complete) override;
  void give_up() override;

  void move_view(Time due, Time now, bool first);
  void send_view(const Pose& pose);
  /// Makes what the View lacks: counts it, and sends proofs of some.
  void make_view();
  void prove(std::uint64_t connection, std::span<const client::MadeChunk> mixed, std::size_t wanted);
  /// An answer to a proof; `found` is the server's hash of the chunk as generated, nullopt if it is edited.
  void judge(const Proofs::Proof& proof, std::optional<ContentHash> found);
  void record_near();
  void count_new_patches(const Box& before, Time due);
  void record_missed(const PendingChunks::MissedChunk& missed, Time now);
  /// Form in which a chunk arrived: in a UniformColumn with others, or in its own message.
  struct ArrivalForm {
    bool alone = false;
    std::uint64_t revision = 0;
  };
  void arrive(ChunkKey chunk, Time now, const ArrivalForm& how);
  void arrive_near(ChunkCoord chunk, Time now, const ArrivalForm& how);
  /// Counts a verdict; returns true if the chunk was awaited.
  [[nodiscard]] bool came(PendingChunks::Verdict verdict, ChunkKey chunk, const ArrivalForm& how);
  /// Call when a chunk arrived: checks whether the View is complete.
  void record_if_full(Time now);

  std::unique_ptr<Motion> motion_;
  Clock::duration tick_;
  Clock::duration phase_;     // of its ticks: players join evenly, but their ticks are not synchronous
  Time began_ = Time::max();  // when it first joined: origin of its time
  Time tick_due_ = Time::max();
  Pose pose_;              // in the last View
  PendingChunks pending_;  // level 0
  PendingRings rings_;
  HeldRevisions revisions_;
  NearWaits near_;
  Proofs proofs_;
  std::uint64_t connection_ = 0;   // of those that it had
  std::uint32_t view_number_ = 0;  // of the last View, if it makes chunks
  std::shared_ptr<bool> is_here_ = std::make_shared<bool>(true);
  std::optional<Time> lost_;      // when the connection was lost, until the nearest rings are complete again
  std::optional<Time> lost_all_;  // the same for the whole View
  bool first_to_come_ = false;
  bool full_to_come_ = false;
  bool horizon_to_come_ = false;
  Time full_since_{};
};

}  // namespace talus::load
