// Heights that somebody waits for, made a piece at a time, so that nobody waits for all of a dear one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "chunks/heights_query.h"
#include "chunks/mailbox.h"
#include "generation/generator.h"

namespace talus::server {

/// The mailbox's owner never gives a ticket twice, so that an answer which a cancellation missed is told from
/// a later one. The heights of one tile are made together, as one may cost as much as all of them.
class HeightsTask {
 public:
  HeightsTask(MailboxPtr mailbox, std::uint64_t ticket, HeightsQuery query);

  [[nodiscard]] const MailboxPtr& mailbox() const { return mailbox_; }
  [[nodiscard]] std::uint64_t ticket() const { return ticket_; }
  /// Columns whose heights are not made.
  [[nodiscard]] std::size_t left() const { return order_.size() - done_; }

  /// What the query asks of the next columns to be made, all of one tile; of none where none is left.
  [[nodiscard]] HeightsQuery next_piece() const;
  /// What makes the next piece; null where it was not begun.
  [[nodiscard]] std::unique_ptr<HeightsMaking>& making() { return making_; }
  [[nodiscard]] bool is_begun() const { return making_ != nullptr; }
  /// Of exactly those columns; they are no longer in the making.
  void add(const HeightsFound& found);
  /// No more are made.
  void give_up() {
    done_ = order_.size();
    making_.reset();
  }
  /// Once none is left: in the order of the request.
  [[nodiscard]] HeightsFound take_found() { return std::move(found_); }

 private:
  MailboxPtr mailbox_;
  std::uint64_t ticket_;
  HeightsQuery query_;
  std::vector<std::uint32_t> order_;  // places in query_.columns, tile by tile
  std::size_t done_ = 0;              // of order_
  HeightsFound found_;
  std::unique_ptr<HeightsMaking> making_;
};

}  // namespace talus::server
