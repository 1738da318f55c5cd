// One simulated client: joins when due, keeps its connection alive, sends credit, may be cut, and reconnects.
// Derived classes define its requests; without them it is an idle connection.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <asio/ip/address.hpp>

#include <talus/client/backoff.h>

#include "link.h"
#include "pending_chunks.h"
#include "random.h"
#include "role.h"

namespace talus::load {

class Worker;
struct Tally;

struct ClientProfile {
  Role role = Role::idle;
  std::uint32_t number = 0;  // among all clients
  std::uint32_t group = 0;
  Clock::duration joins_after{};  // after its role begins
  std::optional<asio::ip::address> from;
};

class SimulatedClient : public LinkOwner {
 public:
  SimulatedClient(Worker& worker, const ClientProfile& profile);

  void start(Time from);
  /// Performs due actions.
  void act(Time now);
  [[nodiscard]] Time due() const;
  Time scheduled = Time::max();  // for the Worker: the due time that it has scheduled

  [[nodiscard]] Role role() const { return profile_.role; }
  /// Stops it from requesting anything new. It does not connect again, unless it has unfinished() work.
  void finish();
  [[nodiscard]] virtual bool satisfied() const { return true; }
  /// Disconnects, and counts what it did not get.
  void leave();

 protected:
  // ---- for derived classes
  virtual void joined(Time /*now*/) {}
  /// The connection ended; `lost`: not on purpose.
  virtual void disconnected(bool /*lost*/) {}
  /// Performs the derived class's due actions, while joined.
  virtual void act_joined(Time /*now*/) {}
  [[nodiscard]] virtual Time own_due() const { return Time::max(); }
  /// Returns true if the client must connect again, also after finish(), to learn the outcome of its work.
  [[nodiscard]] virtual bool unfinished() const { return false; }
  virtual void take(const wire::Chunk& chunk);
  virtual void take(const wire::UniformColumn& column);
  virtual void take(const wire::Unchanged& unchanged);
  virtual void take(const wire::Error& /*error*/) {}
  virtual void take(const wire::Attached& attached);
  virtual void take(const wire::EditResult& result);
  virtual void take(const wire::EditBroadcast& /*broadcast*/) {}
  virtual void take(const wire::ViewComplete& /*complete*/) {}
  virtual void taken_all() {}
  virtual void give_up() {}

  [[nodiscard]] Worker& worker() { return worker_; }
  [[nodiscard]] const Worker& worker() const { return worker_; }
  [[nodiscard]] Tally& tally();
  /// When the connection was lost; nullopt after a Pong of the next one.
  [[nodiscard]] std::optional<Time> lost_since() const { return lost_ ? lost_ : awaits_pong_; }
  [[nodiscard]] const ClientProfile& profile() const { return profile_; }
  [[nodiscard]] Random& random() { return random_; }
  [[nodiscard]] bool is_joined() const { return state_ == State::joined; }
  /// Something was restored after a lost connection: its session, or its editor.
  void is_back(Time lost);
  /// When it should have begun to connect.
  [[nodiscard]] Time join_due() const { return join_due_; }
  [[nodiscard]] std::uint32_t server_frame_bytes() const { return frame_bytes_; }
  /// Index of its server in the plan.
  [[nodiscard]] std::size_t server() const;
  void send(std::span<const std::byte> frame) { link_.send(frame); }
  /// Returns true if the chunk matches its hash and codec, or is not in the sample to be checked; counts a
  /// mismatch.
  bool verify(const wire::Chunk& chunk);
  void wrong(std::uint64_t& counter, const std::string& what);
  void never_came(const std::string& what);

 private:
  enum class State : std::uint8_t { away, connecting, greeting, joined, gone };

  void opened() override;
  void received(const wire::Message& message, std::size_t frame_bytes) override;
  void read_done() override;
  void ended(const std::string& reason, bool broken) override;

  void connect(Time now);
  void welcome(const wire::Welcome& welcome);
  void note_error(const wire::Error& error);
  void cut(Time now);
  void reconnect_at(Time when);
  [[nodiscard]] Clock::duration back_off();

  Worker& worker_;
  ClientProfile profile_;
  Random random_;
  Link link_;
  State state_ = State::away;
  bool finished_ = false;
  Time join_due_ = Time::max();
  Time deadline_ = Time::max();  // for connecting and for Welcome
  Time ping_due_ = Time::max();
  Time cut_due_ = Time::max();
  Time read_due_ = Time::max();  // for a slow reader
  Clock::duration ping_interval_{};
  std::chrono::milliseconds retry_after_{};
  std::optional<client::Backoff> backoff_;  // from the first failure
  std::size_t server_ = 0;                  // in the plan
  std::optional<Time> lost_;                // time of a lost connection, until it joins
  std::optional<Time> awaits_pong_;         // time of that loss, until the first Pong
  std::string close_reason_;
  std::uint32_t frame_bytes_ = 0;
  std::uint8_t codec_ = 0;
  std::uint64_t window_ = 0, taken_ = 0, credited_ = 0;  // bytes of Chunk frames
  std::uint64_t counted_bytes_ = 0;                      // of the link's, in Live
};

}  // namespace talus::load
