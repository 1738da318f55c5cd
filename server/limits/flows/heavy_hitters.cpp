#include "limits/flows/heavy_hitters.h"

#include <algorithm>
#include <cmath>

namespace talus::server {
namespace {

constexpr double kTenSeconds = 10;
constexpr double kMinute = 60;

double left_after(double seconds, double time_constant) {
  return std::exp(-seconds / time_constant);
}

void add_to(FlowFigures& figures, std::uint64_t amount) {
  // These factors keep a steady rate in balance with pass() of a second.
  static const double of_ten_seconds = 1 - left_after(1, kTenSeconds);
  static const double of_a_minute = 1 - left_after(1, kMinute);
  figures.in_ten_seconds += static_cast<double>(amount) * of_ten_seconds;
  figures.in_a_minute += static_cast<double>(amount) * of_a_minute;
  figures.total += amount;
}

}  // namespace

HeavyHitters::HeavyHitters(std::size_t entries) : max_{entries} {}

void HeavyHitters::pass(std::chrono::duration<double> time) {
  const double of_ten_seconds = left_after(time.count(), kTenSeconds);
  const double of_a_minute = left_after(time.count(), kMinute);
  const auto fall = [&](FlowFigures& figures) {
    figures.in_ten_seconds *= of_ten_seconds;
    figures.in_a_minute *= of_a_minute;
  };
  for (Entry& entry : entries_) {
    fall(entry.figures);
    entry.unseen *= of_a_minute;
  }
  fall(all_);
  unlisted_ *= of_a_minute;
}

void HeavyHitters::add(const FlowUse& flow, std::uint64_t amount) {
  // First, so that a failure leaves no place without an entry.
  if (entries_.size() == entries_.capacity()) entries_.reserve(2 * entries_.size() + 1);
  const auto [place, fresh] = place_.try_emplace(flow.id(), entries_.size());
  if (fresh) entries_.push_back({flow.id(), {flow.name()}, unlisted_});
  add_to(entries_[place->second].figures, amount);
  add_to(all_, amount);
}

void HeavyHitters::cut() {
  if (entries_.size() <= max_) return;
  const auto first_cut = entries_.begin() + static_cast<std::ptrdiff_t>(max_);
  std::nth_element(entries_.begin(), first_cut, entries_.end(),
                   [](const Entry& a, const Entry& b) { return a.weight() > b.weight(); });
  unlisted_ = first_cut->weight();
  for (auto cut = first_cut; cut != entries_.end(); ++cut) place_.erase(cut->flow);
  entries_.erase(first_cut, entries_.end());
  for (std::size_t place = 0; place < entries_.size(); ++place) place_.at(entries_[place].flow) = place;
}

std::vector<FlowFigures> HeavyHitters::top(std::size_t count) const {
  std::vector<FlowFigures> figures;
  for (const Entry& entry : entries_) figures.push_back(entry.figures);
  const auto end = figures.begin() + static_cast<std::ptrdiff_t>(std::min(count, figures.size()));
  std::partial_sort(figures.begin(), end, figures.end(),
                    [](const FlowFigures& a, const FlowFigures& b) { return a.in_a_minute > b.in_a_minute; });
  figures.erase(end, figures.end());
  return figures;
}

}  // namespace talus::server
