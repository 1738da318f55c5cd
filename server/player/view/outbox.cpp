#include "player/view/outbox.h"

#include <tuple>
#include <utility>

namespace talus::server {
namespace {

// Memory of a frame in addition to its bytes: its vector, and the overhead of the allocator.
constexpr std::size_t kFrameOverheadBytes = 48;

}  // namespace

void Outbox::push_control(protocol::Frame frame) {
  control_bytes_ += frame.size() + kFrameOverheadBytes;
  control_.push_back(std::move(frame));
}

void Outbox::push_chunk(Entry&& entry) {
  entry.chunk->prefetch();  // it is written soon, among others that lie as far apart in memory
  Queue& lane = entry.request_id == 0 ? view_ : requests_;
  lane.bytes += cost(*entry.chunk);
  lane.entries.push_back(std::move(entry));
}

bool Outbox::sendable(const Credit& credit) const {
  const bool waits = updates() > 0 || !requests_.entries.empty() || !view_.entries.empty();
  return !control_.empty() || (waits && credit.may_send());
}

void Outbox::take_control(std::size_t enough_bytes, Output& output) {
  while (!control_.empty() && output.size() < enough_bytes) {
    const protocol::Frame& frame = control_.front();
    output.append(frame);
    control_bytes_ -= frame.size() + kFrameOverheadBytes;
    control_.pop_front();
  }
}

std::size_t Outbox::bytes_to_copy(std::size_t shared_from) const {
  constexpr std::size_t kHeadBytes = 160;  // more than the bytes before a chunk's payload
  const std::size_t count = chunks(Lane::requests) + chunks(Lane::view);
  const bool shares = shared_from == 0 || chunk_bytes() / shared_from > count;
  return control_bytes_ + (shares ? kHeadBytes * count : chunk_bytes());
}

Outbox::Write::Write(Outbox& outbox, const WriteLimits& limits, Credit& credit, Output& output)
    : outbox_{outbox}, limits_{limits}, credit_{credit}, output_{output}, updates_{outbox.updates_.size()} {
  outbox.take_control(limits.enough_bytes, output);
  control_bytes_ = output.size();
  outbox.wait(Pair::chunks, Flow::requests, !outbox.requests_.entries.empty());
  outbox.wait(Pair::chunks, Flow::view, !outbox.view_.entries.empty());
}

bool Outbox::Write::may_go() const {
  return output_.size() < limits_.enough_bytes && credit_.may_send() && chunks_ < limits_.chunks &&
         output_.size() - control_bytes_ < limits_.chunk_bytes;
}

Outbox::Write::Turn Outbox::Write::next() {
  if (turn_ != Turn::none) {
    outbox_.turns_.charge(static_cast<double>(output_.size() - turn_began_), pair_, flow_);
  }
  turn_began_ = output_.size();
  return turn_ = may_go() ? choose() : Turn::none;
}

Outbox::Write::Turn Outbox::Write::choose() {
  outbox_.wait(Pair::updates, Flow::broadcasts, updates_ > 0);
  outbox_.wait(Pair::updates, Flow::resends, !outbox_.resends_.empty());
  const auto turn = outbox_.turns_.next();
  if (!turn) return Turn::none;
  std::tie(pair_, flow_) = *turn;
  if (pair_ == Pair::updates) return flow_ == Flow::broadcasts ? Turn::broadcasts : Turn::resends;
  const bool view = flow_ == Flow::view;
  if ((view ? outbox_.view_ : outbox_.requests_).entries.empty()) return Turn::none;
  return view ? Turn::view : Turn::requests;
}

ChunkKey Outbox::Write::take_update() {
  const ChunkKey key = outbox_.updates_.front();
  outbox_.updates_.pop_front();
  --updates_;
  return key;
}

ChunkKey Outbox::Write::take_resend() {
  const ChunkKey key = outbox_.resends_.front();
  outbox_.resends_.pop_front();
  return key;
}

Outbox::Entry Outbox::Write::take_chunk() {
  Queue& from = lane();
  Entry entry = std::move(from.entries.front());
  from.entries.pop_front();
  from.bytes -= cost(*entry.chunk);
  return entry;
}

void Outbox::Write::append(const EncodedChunkPtr& chunk, std::uint32_t request_id, ChunkKey key) {
  output_.append(chunk, request_id, key);
  credit_.sent(chunk->frame_bytes());
  ++chunks_;
  chunk_bytes_ += chunk->frame_bytes();
}

}  // namespace talus::server
