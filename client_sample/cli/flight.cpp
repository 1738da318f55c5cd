#include "flight.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace talus::cli {
namespace {

constexpr double kTurn = 6.283185307179586;
constexpr double kSwing = 0.06;    // sideways, as part of the course's length
constexpr double kBeyond = 900.0;  // voxels past the end that determine the view
constexpr double kSubvoxels = 256.0;

client::Column column_at(glm::dvec2 place) {
  return {static_cast<std::int64_t>(std::floor(place.x)), static_cast<std::int64_t>(std::floor(place.y))};
}

glm::dvec2 unit(double heading) {
  return {std::cos(heading), std::sin(heading)};
}

double heading_of(int index) {
  return kTurn * index / kHeadings;
}

}  // namespace

Course::Course(glm::dvec2 start, double heading, double length)
    : start_{start}, along_{unit(heading)}, aside_{-along_.y, along_.x}, length_{std::max(length, 1.0)} {}

glm::dvec2 Course::at(double distance) const {
  const double phase = kTurn * distance / length_;
  return start_ + along_ * distance + aside_ * (kSwing * length_ * 0.5 * (1.0 - std::cos(phase)));
}

glm::dvec2 Course::direction(double distance) const {
  return glm::normalize(at(distance + 0.5) - at(distance - 0.5));
}

double radians_of(double compass_degrees) {
  return (compass_degrees - 90) * kTurn / 360;
}

std::vector<client::Column> candidate_columns(glm::dvec2 start, double length) {
  std::vector<client::Column> columns;
  for (int heading = 0; heading < kHeadings; ++heading) {
    for (int sample = 0; sample < kSamplesPerHeading; ++sample) {
      const double distance = (length + kBeyond) * (sample + 1) / kSamplesPerHeading;
      columns.push_back(column_at(start + unit(heading_of(heading)) * distance));
    }
  }
  return columns;
}

double choose_heading(const std::vector<std::int32_t>& heights_fx) {
  // A good final view has open ground ahead and mountains behind it.
  constexpr std::size_t kWay = kSamplesPerHeading / 3;
  constexpr std::size_t kOpen = kSamplesPerHeading * 2 / 3;
  double best_score = -1e30;
  int best = 0;
  for (int heading = 0; heading < kHeadings; ++heading) {
    const auto begin = static_cast<std::size_t>(heading * kSamplesPerHeading);
    double way = 0;
    double open = 0;
    double far = 0;
    for (std::size_t sample = 0; sample < kSamplesPerHeading; ++sample) {
      const double height = heights_fx.at(begin + sample) / kSubvoxels;
      (sample < kWay ? way : sample < kOpen ? open : far) += height;
    }
    const double score = far - 1.2 * open - 0.3 * way;
    if (score > best_score) {
      best_score = score;
      best = heading;
    }
  }
  return heading_of(best);
}

std::vector<client::Column> course_columns(const Course& course) {
  std::vector<client::Column> columns;
  for (double distance = 0; distance <= course.length() + 64.0; distance += kCourseSpacing) {
    columns.push_back(column_at(course.at(distance)));
  }
  return columns;
}

Altitude::Altitude(const std::vector<std::int32_t>& heights_fx, double clearance) {
  constexpr std::ptrdiff_t kNear = 8;    // samples in each direction whose highest ground counts
  constexpr std::ptrdiff_t kSmooth = 8;  // samples in each direction that are averaged
  const auto count = static_cast<std::ptrdiff_t>(heights_fx.size());
  std::vector<double> highest;
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    const auto first = heights_fx.begin() + std::max<std::ptrdiff_t>(0, i - kNear);
    const auto last = heights_fx.begin() + std::min(count, i + kNear + 1);
    highest.push_back(*std::max_element(first, last) / kSubvoxels + clearance);
  }
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    const std::ptrdiff_t first = std::max<std::ptrdiff_t>(0, i - kSmooth);
    const std::ptrdiff_t last = std::min(count, i + kSmooth + 1);
    double sum = 0;
    for (std::ptrdiff_t j = first; j < last; ++j) sum += highest[static_cast<std::size_t>(j)];
    rows_.push_back(sum / static_cast<double>(last - first));
  }
}

double Altitude::at(double distance) const {
  const double place = std::clamp(distance / kCourseSpacing, 0.0, static_cast<double>(rows_.size() - 1));
  const auto index = std::min(static_cast<std::size_t>(place), rows_.size() - 1);
  const auto next = std::min(index + 1, rows_.size() - 1);
  const double part = place - static_cast<double>(index);
  return rows_[index] * (1.0 - part) + rows_[next] * part;
}

}  // namespace talus::cli
