// Where a player is at a time. Pure: a seed and the times decide.
#pragma once

#include <memory>
#include <vector>

#include <glm/vec3.hpp>
#include <tl/expected.hpp>

#include "random.h"
#include "role.h"

namespace talus::load {

struct Pose {
  glm::dvec3 place{};      // voxels
  glm::dvec3 direction{};  // of the view; zero where it has none
};

class Motion {
 public:
  virtual ~Motion() = default;
  /// `seconds` since the player joined for the first time; never less than in the call before.
  [[nodiscard]] virtual Pose at(double seconds) = 0;
  /// Whether it will ever be somewhere else.
  [[nodiscard]] virtual bool moves() const { return true; }
};

/// A way that was recorded. Voxels relative to where it begins, times in seconds from 0 on, growing.
struct TracePoint {
  double seconds = 0;
  glm::dvec3 place{};
};
using Trace = std::vector<TracePoint>;

/// Lines of "seconds x y z", empty ones and those that begin with # left out. An error names the line.
[[nodiscard]] tl::expected<Trace, std::string> parse_trace(const std::string& text);

struct MotionPlan {
  Role model = Role::stand;  // one of the first six, or slow, which walks
  glm::dvec3 origin{};       // where the player's group begins
  double heading = 0;        // of the group, radians from x towards z
  double speed = 0;          // voxels a second
  double dwell_seconds = 5;  // teleport: from jump to jump
  std::shared_ptr<const Trace> trace;
};

[[nodiscard]] std::unique_ptr<Motion> make_motion(const MotionPlan& plan, Random random);

}  // namespace talus::load
