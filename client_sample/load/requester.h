// A client that requests single chunks in a closed loop: `in_flight` at a time from the fixed set, or
// (greedy) as much fresh terrain as the server allows, for ever. An answer triggers the next request.
#pragma once

#include <vector>

#include "simulated_client.h"

namespace talus::load {

class Requester final : public SimulatedClient {
 public:
  Requester(Worker& worker, const ClientProfile& profile);
  [[nodiscard]] bool satisfied() const override { return open_ == 0 || role() == Role::greedy; }

 private:
  struct Slot {
    ChunkKey key;
    Time asked{};
    bool open = false;
  };

  void joined(Time now) override;
  void disconnected(bool lost) override;
  void take(const wire::Chunk& chunk) override;
  void take(const wire::Error& error) override;
  void taken_all() override;
  void act_joined(Time now) override;
  [[nodiscard]] Time own_due() const override { return ask_due_; }
  void give_up() override;

  [[nodiscard]] ChunkKey next_key();
  /// Closes the request's slot for reuse; null if it is not open.
  [[nodiscard]] Slot* close(std::uint32_t id);
  void ask();

  std::vector<Slot> slots_;            // request id - 1
  std::vector<std::uint32_t> to_ask_;  // ids
  std::size_t open_ = 0;
  Time ask_due_ = Time::max();  // retry time that the server asked for after refusals
  std::int64_t swept_ = 0;
};

}  // namespace talus::load
