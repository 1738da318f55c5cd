// Where the camera flies: a gentle curve over the ground. Pure functions of the heights below.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <talus/client/client.h>

namespace talus::cli {

/// A curve in the plane, base columns (x, z), walked at constant speed.
class Course {
 public:
  /// From `start`, first along `heading` (radians from x towards z).
  Course(glm::dvec2 start, double heading, double length);

  [[nodiscard]] glm::dvec2 at(double distance) const;
  [[nodiscard]] glm::dvec2 direction(double distance) const;
  [[nodiscard]] double length() const { return length_; }

 private:
  glm::dvec2 start_;
  glm::dvec2 along_;
  glm::dvec2 aside_;
  double length_;
};

inline constexpr int kHeadings = 16;
inline constexpr int kSamplesPerHeading = 48;
inline constexpr double kCourseSpacing = 8.0;  // voxels between the heights along a course

/// Columns to look at before a heading is chosen: kSamplesPerHeading along each of kHeadings.
[[nodiscard]] std::vector<client::Column> candidate_columns(glm::dvec2 start, double length);
/// The heading with the highest land in view at its end and low, dry land under the way, of `heights_fx`
/// at candidate_columns().
[[nodiscard]] double choose_heading(const std::vector<std::int32_t>& heights_fx);

/// A Course's heading of one in degrees clockwise from north, which is towards low z.
[[nodiscard]] double radians_of(double compass_degrees);

/// Columns along a course, kCourseSpacing apart, and past its end.
[[nodiscard]] std::vector<client::Column> course_columns(const Course& course);

/// How high to fly: `clearance` above the highest ground near, in smooth lines. `heights_fx` at
/// course_columns().
class Altitude {
 public:
  Altitude(const std::vector<std::int32_t>& heights_fx, double clearance);
  [[nodiscard]] double at(double distance) const;

 private:
  std::vector<double> rows_;
};

}  // namespace talus::cli
