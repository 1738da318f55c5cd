// A client that asks chunk by chunk: of the fixed set so many at a time, or (greedy) as many of fresh terrain
// as the server lets it open, for ever. A closed loop: the next is asked when the one before is answered.
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
  /// The request's slot, now closed and to be asked anew; null where it is not open.
  [[nodiscard]] Slot* close(std::uint32_t id);
  void ask();

  std::vector<Slot> slots_;            // request id - 1
  std::vector<std::uint32_t> to_ask_;  // ids
  std::size_t open_ = 0;
  Time ask_due_ = Time::max();  // the server has refused some, and asks to come back then
  std::int64_t swept_ = 0;
};

}  // namespace talus::load
