// Heights that somebody waits for, or a tile of the map, made a piece at a time, so that nobody waits for all
// of a dear one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "chunks/generation/generator.h"
#include "chunks/heights_query.h"
#include "chunks/mailbox.h"

namespace talus::server {

/// The mailbox's owner never gives a ticket twice, so that an answer which a cancellation missed is told from
/// a later one. The heights of 32 x 32 columns are made together, as one may cost as much as all of them, and
/// so is a tile of the map.
class HeightsTask {
 public:
  HeightsTask(MailboxPtr mailbox, std::uint64_t ticket, HeightsQuery query);

  [[nodiscard]] const MailboxPtr& mailbox() const { return mailbox_; }
  [[nodiscard]] std::uint64_t ticket() const { return ticket_; }
  /// The tile of the map that is asked for; none: heights.
  [[nodiscard]] const std::optional<map::Tile>& tile() const { return query_.tile; }
  /// Columns whose heights are not made, or that are not drawn.
  [[nodiscard]] std::size_t left() const { return columns_ - done_; }

  /// What the query asks of the next columns to be made, all of one tile; of none where none is left.
  [[nodiscard]] HeightsQuery next_piece() const;
  /// What makes the next piece; null where it was not begun.
  [[nodiscard]] std::unique_ptr<HeightsMaking>& making() { return making_; }
  [[nodiscard]] bool is_begun() const { return making_ != nullptr; }
  /// Of exactly those columns; they are no longer in the making.
  void add(const HeightsFound& found);
  /// Once none is left: what was found becomes the body that the query wants of it, if it wants one.
  void write_body();
  /// No more are made.
  void give_up() {
    done_ = columns_;
    making_.reset();
  }
  /// Once none is left: in the order of the request.
  [[nodiscard]] HeightsFound take_found() { return std::move(found_); }

 private:
  MailboxPtr mailbox_;
  std::uint64_t ticket_;
  HeightsQuery query_;
  std::vector<std::uint32_t> order_;  // places in query_.columns, tile by tile
  std::size_t columns_ = 0;           // asked for
  std::size_t done_ = 0;              // of them
  HeightsFound found_;
  std::unique_ptr<HeightsMaking> making_;
};

}  // namespace talus::server
