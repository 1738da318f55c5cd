#include "pending_chunks.h"

#include <algorithm>
#include <cmath>

namespace talus::load {
namespace {

// A View is forgotten when nothing sent for it can still be in flight.
constexpr std::chrono::seconds kOnItsWay{20};
constexpr std::size_t kMaxPast = 1024;  // for a program that was stopped for minutes and catches up
constexpr std::size_t kNearRings = 2;

template <typename Visit>
void for_each(const Box& box, Visit&& visit) {
  for (std::int64_t z = box.low.z; z <= box.high.z; ++z) {
    for (std::int64_t x = box.low.x; x <= box.high.x; ++x) {
      for (std::int64_t y = box.low.y; y <= box.high.y; ++y) visit(glm::i64vec3{x, y, z});
    }
  }
}

}  // namespace

Box box_around(const glm::i64vec3& centre, int horizontal_radius, int vertical_radius) {
  const LevelBox box = level_boxes({centre, horizontal_radius, vertical_radius, {}}).front();
  if (box.count() == 0) return {};
  return {{box.x.first, box.y.first, box.z.first}, {box.x.last, box.y.last, box.z.last}};
}

std::vector<PendingChunks::MissedChunk> PendingChunks::move_to(const Box& box, const glm::i64vec3& centre,
                                                               Time due, Time now) {
  std::vector<MissedChunk> gone;
  if (box == box_) return gone;
  const auto step = static_cast<Cell>(steps_.size() + 1);
  while (!past_.empty() && (past_.back().until + kOnItsWay < now || past_.size() >= kMaxPast))
    past_.pop_back();

  // Distant Views are skipped before checking single chunks: a jumping player has hundreds of them.
  std::vector<Box> left_near;
  for (const Past& past : past_) {
    if (past.box.meets(box)) left_near.push_back(past.box);
  }
  const auto left_this = [&](const glm::i64vec3& at) {
    return std::any_of(left_near.begin(), left_near.end(),
                       [&](const Box& left) { return left.contains(at); });
  };
  std::vector<Cell> cells;
  const glm::i64vec3 size = box.size();
  cells.reserve(static_cast<std::size_t>(size.x * size.y * size.z));
  bool shares = false;
  std::size_t waiting = 0;
  for_each(box, [&](const glm::i64vec3& at) {
    Cell cell = step;
    if (box_.contains(at)) {
      shares = true;
      cell = cells_[index_of(box_, at)];
    } else if (left_this(at)) {
      cell |= kReturned;
    }
    if (cell != 0 && (cell & kReturned) == 0) ++waiting;
    cells.push_back(cell);
  });
  if (!cells_.empty()) {
    std::size_t index = 0;
    for_each(box_, [&](const glm::i64vec3& at) {
      const Cell cell = cells_[index++];
      if ((cell & ~kReturned) != 0 && !box.contains(at)) gone.push_back(missed(cell));
    });
    past_.push_front({box_, now});
  }
  steps_.push_back({due, !shares});
  cells_ = std::move(cells);
  box_ = box;
  centre_ = centre;
  waiting_ = waiting;
  near_waiting_ = 0;
  for_each(box_, [&, index = std::size_t{0}](const glm::i64vec3& at) mutable {
    const Cell cell = cells_[index++];
    if (cell != 0 && (cell & kReturned) == 0 && ring_of(at) < kNearRings) ++near_waiting_;
  });
  waiting_by_ring_.clear();
  if (shares) return gone;
  jumped_ = due;
  std::size_t index = 0;
  for_each(box_, [&](const glm::i64vec3& at) {
    const Cell cell = cells_[index++];
    if ((cell & kReturned) != 0) return;
    const std::size_t ring = ring_of(at);
    if (ring >= waiting_by_ring_.size()) waiting_by_ring_.resize(ring + 1);
    ++waiting_by_ring_[ring];
  });
  return gone;
}

PendingChunks::Arrival PendingChunks::arrive(ChunkCoord chunk) {
  const glm::i64vec3 at = to_vec(chunk);
  if (!box_.contains(at)) return {left_lately(at) ? Verdict::stale : Verdict::outside};
  Cell& cell = cells_[index_of(box_, at)];
  if (cell == 0) return {Verdict::duplicate};
  if (cell == kReturned) return {Verdict::repeated};
  const Cell first_step = cell & ~kReturned;
  const Step& step = steps_[first_step - 1];
  Arrival arrival{Verdict::came, step.due, step.join, static_cast<std::uint32_t>(steps_.size()) - first_step};
  cell &= kReturned;
  if (cell != 0) return arrival;
  --waiting_;
  const std::size_t ring = ring_of(at);
  if (ring < kNearRings) --near_waiting_;
  if (waiting_by_ring_.empty()) return arrival;
  const auto nearest =
      std::find_if(waiting_by_ring_.begin(), waiting_by_ring_.end(), [](auto count) { return count > 0; });
  arrival.ring_gap = static_cast<std::int64_t>(ring) - (nearest - waiting_by_ring_.begin());
  --waiting_by_ring_[ring];
  return arrival;
}

std::size_t PendingChunks::make_all() {
  const auto awaited = [](Cell cell) { return cell != 0; };
  const auto made = static_cast<std::size_t>(std::count_if(cells_.begin(), cells_.end(), awaited));
  std::fill(cells_.begin(), cells_.end(), Cell{0});
  waiting_ = near_waiting_ = 0;
  waiting_by_ring_.clear();
  return made;
}

std::vector<PendingChunks::MissedChunk> PendingChunks::give_up() {
  std::vector<MissedChunk> all;
  for (Cell& cell : cells_) {
    if ((cell & ~kReturned) != 0) all.push_back(missed(cell));
    cell = 0;
  }
  waiting_ = near_waiting_ = 0;
  waiting_by_ring_.clear();
  return all;
}

std::size_t PendingChunks::index_of(const Box& box, const glm::i64vec3& at) const {
  const glm::i64vec3 size = box.size();
  const glm::i64vec3 from = at - box.low;
  return static_cast<std::size_t>((from.z * size.x + from.x) * size.y + from.y);
}

bool PendingChunks::left_lately(const glm::i64vec3& at) const {
  return std::any_of(past_.begin(), past_.end(), [&](const Past& past) { return past.box.contains(at); });
}

std::size_t PendingChunks::ring_of(const glm::i64vec3& at) const {
  const glm::dvec3 offset{at - centre_};
  return static_cast<std::size_t>(std::sqrt(offset.x * offset.x + offset.y * offset.y + offset.z * offset.z));
}

PendingChunks::MissedChunk PendingChunks::missed(Cell cell) const {
  const Step& step = steps_[(cell & ~kReturned) - 1];
  return {step.due, step.join, (cell & kReturned) != 0};
}

}  // namespace talus::load
