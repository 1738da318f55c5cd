// Heights that a client waits for, or a tile of the map, made a piece at a time, so that no client waits for
// all of an expensive one.
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

/// The mailbox's owner never gives a ticket twice, so that an answer that a cancellation missed is distinct
/// from a later one. The heights of 32 x 32 columns are made together, as one may cost as much as all of
/// them, and so is a tile of the map.
class HeightsTask {
 public:
  HeightsTask(MailboxPtr mailbox, std::uint64_t ticket, HeightsQuery query);

  [[nodiscard]] const MailboxPtr& mailbox() const { return mailbox_; }
  [[nodiscard]] std::uint64_t ticket() const { return ticket_; }
  /// Returns the tile of the map that is asked for; nullopt: heights.
  [[nodiscard]] const std::optional<map::Tile>& tile() const { return query_.tile; }
  /// Number of columns whose heights are not made, or that are not drawn.
  [[nodiscard]] std::size_t left() const { return columns_ - done_; }

  /// Returns the query for the next columns to be made, all of one tile; without columns if none is left.
  [[nodiscard]] HeightsQuery next_piece() const;
  /// Returns what makes the next piece; null if it was not begun.
  [[nodiscard]] std::unique_ptr<HeightsBuild>& build() { return build_; }
  [[nodiscard]] bool is_begun() const { return build_ != nullptr; }
  /// Adds the heights of next_piece()'s columns; they are no longer being built.
  void add(const HeightsResult& found);
  /// When no column is left: writes the body that the query wants, if it wants one.
  void write_body();
  /// Ends the task: no more heights are made.
  void give_up() {
    done_ = columns_;
    build_.reset();
  }
  /// When no column is left: returns the heights in the order of the request.
  [[nodiscard]] HeightsResult take_found() { return std::move(found_); }

 private:
  MailboxPtr mailbox_;
  std::uint64_t ticket_;
  HeightsQuery query_;
  std::vector<std::uint32_t> order_;  // places in query_.columns, tile by tile
  std::size_t columns_ = 0;           // number of columns asked for
  std::size_t done_ = 0;              // number of columns made
  HeightsResult found_;
  std::unique_ptr<HeightsBuild> build_;
};

}  // namespace talus::server
