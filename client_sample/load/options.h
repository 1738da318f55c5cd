// Options of talus-load.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "command_line/connect_options.h"
#include "player_mix.h"
#include "thresholds.h"

namespace talus::load {

struct Options {
  command_line::ConnectOptions connect;

  std::uint32_t players = 100;
  double seconds = 30;                    // measured time
  double ramp_up_seconds = 0;             // time in which the players join
  std::optional<double> warm_up_seconds;  // delay from the last join to the measurement; nullopt: measure
                                          // from the start
  double drain_seconds = 10;              // for chunks still awaited at the end
  std::uint64_t seed = 1;
  std::uint32_t threads = 1;
  std::uint32_t from_addresses = 1;
  bool groups_together = false;  // each group uses a single one of several servers

  std::string model = "walk";
  PlayerMix mix;  // parsed from `model`
  std::uint32_t groups = 0;
  std::optional<double> speed;  // voxels per second
  std::uint16_t radius = 8;     // chunks
  std::uint16_t vertical = 4;
  std::uint16_t horizon = 0;  // chunks; 0: no rings
  double tick_hz = 10;
  bool every_tick = false;
  double dwell_seconds = 5;
  double churn_seconds = 0;  // mean stay; 0: to the end
  client::Generate generate = client::Generate::never;

  std::uint32_t idle = 0;
  std::uint32_t greedy = 0;
  std::uint32_t slow = 0;
  double slow_kbit = 64;

  double edits = 0;                   // per second and player; 0: players edit only if `edits_in_flight` is
                                      // set
  std::uint32_t edit_group = 1;       // players that share a place
  std::uint32_t edits_in_flight = 0;  // per player, instead of a rate
  std::string edits_file;             // for acknowledged edits; may be empty
  [[nodiscard]] bool builds() const { return edits > 0 || edits_in_flight != 0; }

  std::uint32_t in_flight = 0;  // requests mode unless 0
  std::uint32_t fixed_set = 1024;

  int patch_tiles = 0;  // 0: patches of new land are not counted

  double verify_percent = 1;
  int ring_tolerance = 4;

  std::optional<protocol::Endpoint> metrics;
  int server_pid = 0;

  std::string json, plot, compare;
  std::vector<Threshold> fail_if;
};

}  // namespace talus::load
