#include "generation/heights_task.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include <talus/voxel/coords.h>

namespace talus::server {
namespace {

std::pair<std::int64_t, std::int64_t> tile_of(const terrain::BaseColumn& column) {
  return {floor_div(column.z, kChunkSize), floor_div(column.x, kChunkSize)};
}

}  // namespace

HeightsTask::HeightsTask(MailboxPtr mailbox, std::uint64_t ticket, std::vector<terrain::BaseColumn> columns)
    : mailbox_{std::move(mailbox)},
      ticket_{ticket},
      columns_{std::move(columns)},
      order_(columns_.size()),
      heights_(columns_.size()) {
  std::iota(order_.begin(), order_.end(), 0U);
  std::sort(order_.begin(), order_.end(), [&](std::uint32_t a, std::uint32_t b) {
    return std::pair{tile_of(columns_[a]), a} < std::pair{tile_of(columns_[b]), b};
  });
}

std::vector<terrain::BaseColumn> HeightsTask::next_piece() const {
  std::vector<terrain::BaseColumn> piece;
  for (std::size_t i = done_; i < order_.size(); ++i) {
    const terrain::BaseColumn& column = columns_[order_[i]];
    if (!piece.empty() && tile_of(column) != tile_of(piece.front())) break;
    piece.push_back(column);
  }
  return piece;
}

void HeightsTask::add(const std::vector<std::int32_t>& heights) {
  for (const std::int32_t height : heights) heights_[order_[done_++]] = height;
  making_.reset();
}

}  // namespace talus::server
