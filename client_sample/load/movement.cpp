#include "movement.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <utility>

#include <glm/geometric.hpp>

namespace talus::load {
namespace {

constexpr double kTurn = 6.283185307179586;
constexpr double kApart = 8;  // maximum distance within a group at the start, voxels

glm::dvec3 ahead(double heading) {
  return {std::cos(heading), 0, std::sin(heading)};
}

glm::dvec3 scattered(const glm::dvec3& origin, double radius, Random& random) {
  return origin + ahead(random.between(0, kTurn)) * random.between(0, radius);
}

class NoMotion final : public Motion {
 public:
  explicit NoMotion(const glm::dvec3& place) : place_{place} {}
  Pose at(double) override { return {place_, {}}; }
  [[nodiscard]] bool moves() const override { return false; }

 private:
  glm::dvec3 place_;
};

class Flight final : public Motion {
 public:
  Flight(const glm::dvec3& start, double heading, double speed)
      : start_{start}, ahead_{ahead(heading)}, speed_{speed} {}
  Pose at(double seconds) override { return {start_ + ahead_ * (speed_ * seconds), ahead_}; }

 private:
  glm::dvec3 start_, ahead_;
  double speed_;
};

/// Straight on for some seconds, then in another direction.
class Walk final : public Motion {
 public:
  Walk(const glm::dvec3& start, double speed, Random random) : from_{start}, speed_{speed}, random_{random} {
    turn();
  }
  Pose at(double seconds) override {
    while (seconds > until_) {
      from_ += ahead_ * (speed_ * (until_ - since_));
      since_ = until_;
      turn();
    }
    return {from_ + ahead_ * (speed_ * (seconds - since_)), ahead_};
  }

 private:
  void turn() {
    ahead_ = ahead(random_.between(0, kTurn));
    until_ = since_ + random_.between(3, 9);
  }

  glm::dvec3 from_, ahead_{};
  double speed_;
  double since_ = 0, until_ = 0;
  Random random_;
};

class Teleports final : public Motion {
 public:
  Teleports(const glm::dvec3& origin, double dwell_seconds, Random random)
      : origin_{origin}, place_{origin}, dwell_{dwell_seconds}, random_{random} {
    until_ = random_.between(0, dwell_);  // so that players do not all jump at once
  }
  Pose at(double seconds) override {
    constexpr double kFar = 1 << 20;
    for (; seconds >= until_; until_ += dwell_) {
      place_ = origin_ + glm::dvec3{random_.between(-kFar, kFar), 0, random_.between(-kFar, kFar)};
    }
    return {place_, {}};
  }

 private:
  glm::dvec3 origin_, place_;
  double dwell_, until_ = 0;
  Random random_;
};

/// From the surroundings to one place, then around in it.
class SwarmWalk final : public Motion {
 public:
  SwarmWalk(const glm::dvec3& goal, double speed, Random random)
      : start_{scattered(goal, 1500, random)},
        goal_{scattered(goal, kApart, random)},
        speed_{speed},
        about_{goal_, speed / 4, random} {}
  Pose at(double seconds) override {
    const double way = glm::length(goal_ - start_);
    const double gone = speed_ * seconds;
    if (gone >= way) return about_.at(seconds - way / std::max(speed_, 1e-9));
    const glm::dvec3 direction = (goal_ - start_) / way;
    return {start_ + direction * gone, direction};
  }

 private:
  glm::dvec3 start_, goal_;
  double speed_;
  Walk about_;
};

class TracePlayback final : public Motion {
 public:
  TracePlayback(const glm::dvec3& origin, std::shared_ptr<const Trace> trace)
      : origin_{origin}, trace_{std::move(trace)} {}
  Pose at(double seconds) override {
    while (next_ + 1 < trace_->size() && (*trace_)[next_].seconds < seconds) ++next_;
    const TracePoint& to = (*trace_)[next_];
    const TracePoint& from = (*trace_)[next_ == 0 ? 0 : next_ - 1];
    const double span = to.seconds - from.seconds;
    const double part = span <= 0 ? 1 : std::clamp((seconds - from.seconds) / span, 0.0, 1.0);
    return {origin_ + from.place + (to.place - from.place) * part, to.place - from.place};
  }

 private:
  glm::dvec3 origin_;
  std::shared_ptr<const Trace> trace_;
  std::size_t next_ = 0;
};

}  // namespace

std::unique_ptr<Motion> make_motion(const MotionPlan& plan, Random random) {
  const glm::dvec3 start = scattered(plan.origin, kApart, random);
  switch (plan.model) {
    case Role::walk:
    case Role::slow:
      return std::make_unique<Walk>(start, plan.speed, random);
    case Role::fly:
      return std::make_unique<Flight>(start, plan.heading, plan.speed);
    case Role::teleport:
      return std::make_unique<Teleports>(start, plan.dwell_seconds, random);
    case Role::swarm:
      return std::make_unique<SwarmWalk>(plan.origin, plan.speed, random);
    case Role::trace:
      return std::make_unique<TracePlayback>(plan.origin, plan.trace);
    default:
      return std::make_unique<NoMotion>(start);
  }
}

tl::expected<Trace, std::string> parse_trace(const std::string& text) {
  Trace trace;
  std::istringstream lines{text};
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    if (line.find_first_not_of(" \t\r") == std::string::npos || line.front() == '#') continue;
    const auto wrong = [number](const std::string& why) {
      return tl::unexpected{std::to_string(number) + ": " + why};
    };
    std::istringstream words{line};
    TracePoint point;
    std::string rest;
    if (!(words >> point.seconds >> point.place.x >> point.place.y >> point.place.z) || (words >> rest)) {
      return wrong("not four numbers; a line is: seconds x y z");
    }
    if (trace.empty() ? point.seconds != 0 : point.seconds <= trace.back().seconds) {
      return wrong("the times begin at 0 and grow from line to line");
    }
    trace.push_back(point);
  }
  if (trace.empty()) return tl::unexpected{std::string{"1: no point; a line is: seconds x y z"}};
  return trace;
}

}  // namespace talus::load
