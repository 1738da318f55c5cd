// Metrics of a running talusd. Every module updates its own counters, from any thread. metrics_page.h defines
// the names that operators see.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "runtime/metrics/instruments.h"

namespace talus::server {

/// First digit of an HTTP status.
enum class StatusClass : std::uint8_t {};
inline constexpr std::array<std::string_view, 6> kStatusClasses{"", "1xx", "2xx", "3xx", "4xx", "5xx"};

/// Kind of answer that an HTTP request asks for.
enum class AnswerKind : std::uint8_t { chunk, columns, edits, heights, map, file, other };
inline constexpr std::array<std::string_view, 7> kAnswerKinds{"chunk", "columns", "edits", "heights",
                                                              "map",   "file",    "other"};

struct Metrics {
  // ---- connections
  Counter accepted;
  LabelledCounters refused;  // by reason, before a session began
  Gauge handshakes;          // PROXY headers and TLS handshakes in flight
  Counter tls_handshakes;    // completed
  Counter tls_failed;
  Counter tls_late;
  Gauge open;
  Gauge greeted;                   // open connections whose Hello was accepted
  Counter sent_elsewhere;          // sessions, because this server had more than its share
  Gauge web_open;                  // HTTP connections; WebSocket streams count in `open`
  LabelledCounters web_responses;  // by the first digit of their status
  Counter received_bytes;
  Counter sent_bytes;

  // ---- what clients are sent
  LabelledCounters errors;         // by error code
  LabelledCounters auth_failures;  // by reason
  LabelledCounters throttled_by;   // by rate: it refused a request or delayed chunks
  Counter chunks_sent;
  Counter columns_sent;
  Counter unchanged_sent;
  Counter broadcasts_sent;
  Counter chunk_bytes_sent;  // size of their frames
  Gauge views_local;         // of clients that make chunks themselves
  Gauge views_stream;        // of others
  Counter proofs_failed;     // chunks that such a client made otherwise

  /// From when a session begins to serve a request for a chunk to when the chunk is ready to be sent. Hot:
  /// the chunk was cached (one time for all chunks of a batch, which are sent together). Cold: it waited for
  /// a generator. Transfer over the client's link does not count.
  LatencyHistogram hot_latency;
  LatencyHistogram cold_latency;
  /// From a complete HTTP request to its answer being ready to be sent, by kind of answer.
  std::array<LatencyHistogram, kAnswerKinds.size()> web_latency;

  // ---- edits
  LabelledCounters edits_refused;  // edits and Attaches, by reason
  /// From when a session submits an edit to when it is stored and the session is notified.
  LatencyHistogram edit_latency;

  // ---- what peers download
  Counter checkpoints_sent;     // completely sent
  Counter checkpoints_refused;  // wrong token, or the maximum is being sent
  Counter checkpoint_bytes_sent;
  Gauge checkpoints_open;  // being made or sent

  // ---- where chunks come from
  Counter cache_hits;
  Counter cache_misses;
  Counter uniform_answers;  // chunks of a single material
  Counter patches_made;
  Counter patch_ns;
  Counter chunks_made;
  Counter chunk_ns;
  Counter heights_made;  // columns
  Counter heights_ns;
  Counter map_tiles_made;
  Counter map_tiles_found;  // in the cache
  Counter map_ns;
  Counter jobs_refused;
  Counter jobs_cancelled;  // the last waiting client left

  // The argument is a value of the enum that belongs to the counters (see MetricLabels).
  Counter& throttled(auto rate) { return throttled_by[rate]; }
  Counter& denied(auto failure) { return auth_failures[failure]; }
  Counter& refused_for(auto reason) { return refused[reason]; }
  Counter& error(auto code) { return errors[code]; }
  LatencyHistogram& web_latency_of(AnswerKind kind) { return web_latency[static_cast<std::size_t>(kind)]; }
  Counter& http_responses_of(int status) { return web_responses[static_cast<StatusClass>(status / 100)]; }
};

}  // namespace talus::server
