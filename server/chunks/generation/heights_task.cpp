#include "chunks/generation/heights_task.h"

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

HeightsTask::HeightsTask(MailboxPtr mailbox, std::uint64_t ticket, HeightsQuery query)
    : mailbox_{std::move(mailbox)}, ticket_{ticket}, query_{std::move(query)}, order_(query_.columns.size()) {
  const std::size_t columns = query_.columns.size();
  columns_ = query_.tile ? std::size_t{map::kTilePixels} * map::kTilePixels : columns;
  found_.heights_fx.resize(columns);
  if (query_.looks) found_.looks.resize(columns);
  found_.values.resize(columns * query_.fields.size());
  std::iota(order_.begin(), order_.end(), 0U);
  std::sort(order_.begin(), order_.end(), [&](std::uint32_t a, std::uint32_t b) {
    return std::pair{tile_of(query_.columns[a]), a} < std::pair{tile_of(query_.columns[b]), b};
  });
}

HeightsQuery HeightsTask::next_piece() const {
  HeightsQuery piece{{}, query_.looks, query_.fields, query_.tile};
  for (std::size_t i = done_; i < order_.size(); ++i) {
    const terrain::BaseColumn& column = query_.columns[order_[i]];
    if (!piece.columns.empty() && tile_of(column) != tile_of(piece.columns.front())) break;
    piece.columns.push_back(column);
  }
  return piece;
}

void HeightsTask::add(const HeightsResult& found) {
  if (query_.tile) {
    found_.picture = found.picture;
    done_ = columns_;
  }
  const std::size_t fields = query_.fields.size();
  for (std::size_t i = 0; i < found.heights_fx.size(); ++i) {
    const std::size_t place = order_[done_++];
    found_.heights_fx[place] = found.heights_fx[i];
    if (query_.looks) found_.looks[place] = found.looks[i];
    std::copy_n(found.values.begin() + static_cast<std::ptrdiff_t>(i * fields), fields,
                found_.values.begin() + static_cast<std::ptrdiff_t>(place * fields));
  }
  build_.reset();
}

void HeightsTask::write_body() {
  if (query_.body) found_ = {.body = query_.body(found_)};
}

}  // namespace talus::server
