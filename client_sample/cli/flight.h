// Path of the camera: a gentle curve above the ground. Pure functions of the heights below.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <talus/client/client.h>

namespace talus::cli {

/// A curve in the plane, in base columns (x, z), followed at constant speed.
class Course {
 public:
  /// From `start`, initially along `heading` (radians from x towards z).
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

/// Columns to examine before choosing a heading: kSamplesPerHeading along each of kHeadings.
[[nodiscard]] std::vector<client::Column> candidate_columns(glm::dvec2 start, double length);
/// The heading with the highest land in view at its end and low, dry land on the way; `heights_fx` are the
/// heights at candidate_columns().
[[nodiscard]] double choose_heading(const std::vector<std::int32_t>& heights_fx);

/// Converts degrees clockwise from north, which is towards low z, to a Course's heading.
[[nodiscard]] double radians_of(double compass_degrees);

/// Columns along a course and past its end, kCourseSpacing apart.
[[nodiscard]] std::vector<client::Column> course_columns(const Course& course);

/// Altitude of the flight: smoothly `clearance` above the highest ground nearby. `heights_fx` are the heights
/// at course_columns().
class Altitude {
 public:
  Altitude(const std::vector<std::int32_t>& heights_fx, double clearance);
  [[nodiscard]] double at(double distance) const;

 private:
  std::vector<double> rows_;
};

}  // namespace talus::cli
