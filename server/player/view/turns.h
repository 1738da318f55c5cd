// Whose turn it is to be written to one client, while its credit lasts: four flows, which share by bytes.
//
//   what is sent for a View or a request     and     updates of what was sent
//     requests  and  the View                          broadcasts  and  resent chunks
//
// Each pair is a deficit round robin of two flows whose quantum is one frame: while both wait, each gets half
// to within one frame, so nothing that others do to the land keeps a client's View from coming. Broadcasts
// are small and wanted at once: they may be kBroadcastsAhead bytes ahead of what they share with.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace talus::server {

class Turns {
 public:
  enum class Flow : std::uint8_t { none, broadcasts, resends, requests, view };

  /// Which flows have something that waits.
  struct Waiting {
    bool broadcasts = false;
    bool resends = false;
    bool requests = false;
    bool view = false;

    [[nodiscard]] bool updates() const { return broadcasts || resends; }
    [[nodiscard]] bool chunks() const { return requests || view; }
  };

  static constexpr std::ptrdiff_t kBroadcastsAhead = std::ptrdiff_t{16} * 1024;

  [[nodiscard]] Flow next(const Waiting& waiting) {
    // What one was sent while the other wanted nothing is no debt.
    if (!waiting.chunks()) updates_ahead_ = 0;
    if (!waiting.requests || !waiting.view) requests_ahead_ = 0;
    if (!waiting.resends) broadcasts_ahead_ = 0;
    if (waiting.updates()) {
      const bool resend = waiting.resends && (!waiting.broadcasts || broadcasts_ahead_ >= kBroadcastsAhead);
      const bool may_go = resend ? updates_ahead_ <= 0 : updates_ahead_ < kBroadcastsAhead;
      if (may_go) return resend ? Flow::resends : Flow::broadcasts;
    }
    if (!waiting.chunks()) return Flow::none;
    return waiting.requests && requests_ahead_ <= 0 ? Flow::requests
           : waiting.view                           ? Flow::view
                                                    : Flow::requests;
  }

  /// `flow` was sent so many bytes, in the turn that next(waiting) gave it.
  void sent(Flow flow, std::size_t bytes, const Waiting& waiting) {
    const auto count = static_cast<std::ptrdiff_t>(bytes);
    switch (flow) {
      case Flow::none:
        break;
      case Flow::broadcasts:
        updates_ahead_ += count;
        broadcasts_ahead_ += count;
        break;
      case Flow::resends:
        updates_ahead_ += count;
        broadcasts_ahead_ -= count;
        break;
      case Flow::requests:
      case Flow::view:
        requests_ahead_ += flow == Flow::requests ? count : -count;
        updates_ahead_ -= count;
        // Broadcasts that come one by one pay for what they were ahead, and save up nothing.
        if (!waiting.updates()) updates_ahead_ = std::max<std::ptrdiff_t>(updates_ahead_, 0);
        break;
    }
  }

 private:
  // Bytes that the one was sent more than the other since both wait.
  std::ptrdiff_t updates_ahead_ = 0;     // of chunks
  std::ptrdiff_t requests_ahead_ = 0;    // of the View
  std::ptrdiff_t broadcasts_ahead_ = 0;  // of resent chunks
};

}  // namespace talus::server
