// Puts control frames into a session's outbox, and counts them.
#pragma once

#include <chrono>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include <talus/protocol/message.h>
#include <talus/voxel/coords.h>

#include "player/session/reply_frames.h"
#include "player/session/wire_error.h"
#include "player/view/outbox.h"
#include "runtime/metrics/metrics.h"

namespace talus::server {

class Replies {
 public:
  Replies(Outbox& outbox, Metrics& metrics) : outbox_{outbox}, metrics_{metrics} {}

  void welcome(const Greeting& greeting, const WorldInfo& world, const SessionLimits& limits,
               const RateLimits& rates) {
    outbox_.push_control(welcome_frame(greeting, world, limits, rates));
  }
  void error(const Subject& subject, wire::ErrorCode code, std::string_view text,
             std::chrono::milliseconds retry_after = retry_after::kNever) {
    metrics_.error(code).add();
    if (code == wire::ErrorCode::overloaded || code == wire::ErrorCode::too_many_requests) ++refusals_;
    outbox_.push_control(error_frame(code, text, subject, retry_after));
  }
  void error(const Subject& subject, const EditError& error) {
    const WireError on_wire = wire_error(error.code);
    this->error(subject, on_wire.code, client_text(error), on_wire.retry_after);
  }
  /// Sends a Chunk as a control frame, for chunks smaller than an Error. The caller charges its credit.
  void small_chunk(std::uint32_t request_id, ChunkKey key, const EncodedChunk& chunk) {
    metrics_.chunks_sent.add();
    metrics_.chunk_bytes_sent.add(chunk.frame_bytes());
    outbox_.push_control(chunk_frame(request_id, key, chunk));
  }
  /// `request_id` 0: for the View.
  void unchanged(std::uint32_t request_id, ChunkKey key, const EncodedChunk& chunk) {
    metrics_.unchanged_sent.add();
    outbox_.push_control(unchanged_frame(request_id, key, chunk));
  }
  void column(ChunkKey column, const std::vector<wire::UniformRun>& runs) {
    metrics_.columns_sent.add();
    outbox_.push_control(column_frame(column, runs));
  }
  void view_complete(std::uint32_t number) { outbox_.push_control(view_complete_frame(number)); }
  void heights(std::uint32_t request_id, const HeightsResult& found) {
    outbox_.push_control(heights_frame(request_id, found));
  }
  void file_part(std::uint32_t request_id, std::uint64_t size, std::string_view bytes) {
    outbox_.push_control(file_part_frame(request_id, size, bytes));
  }
  void attached(const EditorSession& editor, std::uint64_t voxels_per_second) {
    outbox_.push_control(attached_frame(editor, voxels_per_second));
  }
  void edit_result(std::uint32_t request_id, const edits::EditResult& result) {
    outbox_.push_control(edit_result_frame(request_id, result));
  }
  void pong(std::uint64_t nonce) { outbox_.push_control(pong_frame(nonce)); }
  void go_away(std::string_view reason, std::chrono::milliseconds retry_after) {
    outbox_.push_control(go_away_frame(reason, retry_after));
  }

  /// Sends bytes of another protocol.
  void foreign(std::vector<std::byte> bytes) { outbox_.push_control(std::move(bytes)); }

  /// Number of refusals of too many or too fast requests since the last call.
  [[nodiscard]] std::uint64_t take_refusals() { return std::exchange(refusals_, 0); }

 private:
  Outbox& outbox_;
  Metrics& metrics_;
  std::uint64_t refusals_ = 0;
};

}  // namespace talus::server
