// One simulated client: joins when it is due, keeps its connection alive, gives credit, may be cut, and comes
// back. What it wants is its descendants' matter; by itself it is an idle connection.
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
  std::uint32_t number = 0;  // of all clients
  std::uint32_t group = 0;
  Clock::duration joins_after{};  // from when its kind begins
  std::optional<asio::ip::address> from;
};

class SimulatedClient : public LinkOwner {
 public:
  SimulatedClient(Worker& worker, const ClientProfile& profile);

  void start(Time from);
  /// What is due is done.
  void act(Time now);
  [[nodiscard]] Time due() const;
  Time scheduled = Time::max();  // the Worker's: the due time that it knows of

  [[nodiscard]] Role role() const { return profile_.role; }
  /// Wants nothing more than it does.
  void finish();
  [[nodiscard]] virtual bool satisfied() const { return true; }
  /// What it did not get is counted.
  void leave();

 protected:
  // ---- for descendants
  virtual void joined(Time /*now*/) {}
  /// The connection ended, unasked where `lost`.
  virtual void disconnected(bool /*lost*/) {}
  /// What is due of its own, while joined.
  virtual void act_joined(Time /*now*/) {}
  [[nodiscard]] virtual Time own_due() const { return Time::max(); }
  virtual void take(const wire::Chunk& chunk);
  virtual void take(const wire::UniformColumn& column);
  virtual void take(const wire::Unchanged& unchanged);
  virtual void take(const wire::Error& /*error*/) {}
  virtual void take(const wire::Attached& attached);
  virtual void take(const wire::EditResult& result);
  virtual void take(const wire::EditBroadcast& /*broadcast*/) {}
  virtual void taken_all() {}
  virtual void give_up() {}

  [[nodiscard]] Worker& worker() { return worker_; }
  [[nodiscard]] const Worker& worker() const { return worker_; }
  [[nodiscard]] Tally& tally();
  /// Since when it has lost its connection, and not seen a Pong of the next one.
  [[nodiscard]] std::optional<Time> lost_since() const { return lost_ ? lost_ : awaits_pong_; }
  [[nodiscard]] const ClientProfile& profile() const { return profile_; }
  [[nodiscard]] Random& random() { return random_; }
  [[nodiscard]] bool is_joined() const { return state_ == State::joined; }
  /// Something that it had before its connection was lost is there again: its session, or its editor.
  void is_back(Time lost);
  /// When it should have begun to connect.
  [[nodiscard]] Time join_due() const { return join_due_; }
  [[nodiscard]] std::uint32_t server_frame_bytes() const { return frame_bytes_; }
  /// Which of the plan's it goes to.
  [[nodiscard]] std::size_t server() const;
  void send(std::span<const std::byte> frame) { link_.send(frame); }
  /// Whether the chunk is what its hash and codec say, where it is one of those that are looked at; what is
  /// not is counted.
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
  Time deadline_ = Time::max();  // for connecting and greeting
  Time ping_due_ = Time::max();
  Time cut_due_ = Time::max();
  Time read_due_ = Time::max();  // of a slow reader
  Clock::duration ping_interval_{};
  std::chrono::milliseconds retry_after_{};
  std::optional<client::Backoff> backoff_;  // from the first failure on
  std::size_t server_ = 0;                  // of the plan's
  std::optional<Time> lost_;                // when its connection was, where it has not joined since
  std::optional<Time> awaits_pong_;         // from when it was lost, the first since
  std::string close_reason_;
  std::uint32_t frame_bytes_ = 0;
  std::uint8_t codec_ = 0;
  std::uint64_t window_ = 0, taken_ = 0, credited_ = 0;  // bytes of Chunk frames
  std::uint64_t counted_bytes_ = 0;                      // of the link's, in Live
};

}  // namespace talus::load
