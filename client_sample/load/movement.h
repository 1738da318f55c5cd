// Position of a player over time. Pure: determined by a seed and the time.
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
  glm::dvec3 direction{};  // view direction; zero if it has no direction
};

class Motion {
 public:
  virtual ~Motion() = default;
  /// `seconds` since the player first joined; must not decrease between calls.
  [[nodiscard]] virtual Pose at(double seconds) = 0;
  /// True if it will ever be elsewhere.
  [[nodiscard]] virtual bool moves() const { return true; }
};

/// A recorded path: voxels relative to its beginning, ascending times in seconds from 0.
struct TracePoint {
  double seconds = 0;
  glm::dvec3 place{};
};
using Trace = std::vector<TracePoint>;

/// Parses lines of "seconds x y z", ignoring empty lines and lines that begin with #. An error names the
/// line.
[[nodiscard]] tl::expected<Trace, std::string> parse_trace(const std::string& text);

struct MotionPlan {
  Role model = Role::stand;  // one of the first six, or slow, which walks
  glm::dvec3 origin{};       // start of the player's group
  double heading = 0;        // the group's, radians from x towards z
  double speed = 0;          // voxels per second
  double dwell_seconds = 5;  // teleport: time between jumps
  std::shared_ptr<const Trace> trace;
};

[[nodiscard]] std::unique_ptr<Motion> make_motion(const MotionPlan& plan, Random random);

}  // namespace talus::load
