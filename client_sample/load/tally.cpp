#include "tally.h"

#include <algorithm>

namespace talus::load {
namespace {

using Counts = std::map<std::string, std::uint64_t>;

std::uint64_t sum_of(const Counts& counts) {
  std::uint64_t sum = 0;
  for (const auto& [name, count] : counts) sum += count;
  return sum;
}

}  // namespace

void Tally::merge(const Tally& other) {
  join.merge(other.join);
  travel.merge(other.travel);
  requests.merge(other.requests);
  first_chunk.merge(other.first_chunk);
  full_view.merge(other.full_view);
  horizon.merge(other.horizon);
  near.merge(other.near);
  returns.merge(other.returns);
  back.merge(other.back);
  full_again.merge(other.full_again);
  edit_ack.merge(other.edit_ack);
  edit_arrival.merge(other.edit_arrival);
  edit_other_server.merge(other.edit_other_server);
  longest_without = std::max(longest_without, other.longest_without);
  for (std::size_t i = 0; i < late_steps.size(); ++i) late_steps[i] += other.late_steps[i];
  constexpr std::uint64_t Tally::*kCounts[] = {
      &Tally::chunks,        &Tally::chunk_bytes,   &Tally::uniform,       &Tally::unchanged,
      &Tally::stale,         &Tally::repeated,      &Tally::updated,       &Tally::missed,
      &Tally::unconfirmed,   &Tally::verified,      &Tally::bad_chunks,    &Tally::outside,
      &Tally::duplicates,    &Tally::unanswered,    &Tally::ordered,       &Tally::disordered,
      &Tally::joins,         &Tally::cuts,          &Tally::bad_messages,  &Tally::reconnects,
      &Tally::new_patches,   &Tally::edits,         &Tally::edited_voxels, &Tally::edit_arrivals,
      &Tally::edits_unknown, &Tally::edits_missing, &Tally::made,          &Tally::proofs,
      &Tally::failed_proofs,
  };
  for (const auto count : kCounts) this->*count += other.*count;
  worst_ring_gap = std::max(worst_ring_gap, other.worst_ring_gap);
  if (first_wrong.empty()) first_wrong = other.first_wrong;
  if (first_missing.empty()) first_missing = other.first_missing;
  if (first_refused.empty()) first_refused = other.first_refused;
  if (first_unanswered.empty()) first_unanswered = other.first_unanswered;
  for (const auto& [code, count] : other.errors) errors[code] += count;
  for (const auto& [reason, count] : other.disconnects) disconnects[reason] += count;
}

void Tally::wrong(std::uint64_t& counter, const std::string& what) {
  ++counter;
  if (first_wrong.empty()) first_wrong = what;
}

void Tally::never_came(const std::string& what) {
  ++unanswered;
  if (first_unanswered.empty()) first_unanswered = what;
}

std::uint64_t Tally::error_count() const {
  return sum_of(errors);
}

std::uint64_t Tally::disconnect_count() const {
  return sum_of(disconnects);
}

}  // namespace talus::load
