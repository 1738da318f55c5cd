#include "builder.h"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include <talus/edits/runs.h>
#include <talus/voxel/codec.h>

#include "tally.h"
#include "worker.h"

namespace talus::load {
namespace {

Clock::duration period_of(const Options& options) {
  if (options.edits_in_flight != 0) return {};
  return std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(1 / options.edits));
}

/// A server's text as one printable line of bounded length.
std::string said(const wire::Error& error) {
  std::string text = wire::EnumNameErrorCode(error.code());
  if (error.text() != nullptr) text += ": " + error.text()->str().substr(0, 200);
  for (char& each : text) {
    if (static_cast<unsigned char>(each) < 0x20 || each == 0x7F) each = '?';
  }
  return text;
}

std::uint32_t place_in_group(const Options& options, std::uint32_t client) {
  return client / options.groups;
}

}  // namespace

Builder::Builder(Worker& worker, const ClientProfile& profile, std::shared_ptr<EditSite> site)
    : SimulatedClient{worker, profile},
      site_{std::move(site)},
      place_{place_in_group(worker.plan().options, profile.number)},
      period_{period_of(worker.plan().options)} {}

// ---- schedule

void Builder::joined(Time now) {
  revisions_.assign(site_->parts().size(), std::nullopt);
  seen_.assign(site_->size(), std::nullopt);
  attach_ = Attach::wanted;
  hold_until_ = {};
  if (next_due_ == Time::max() && period_ != Clock::duration{}) {
    // Spreads the builders over the period.
    next_due_ =
        join_due() + std::chrono::duration_cast<Clock::duration>(
                         period_ * Random{worker().plan().options.seed ^ 0xED17, profile().number}.part());
  }
  send_view();
  send_due(now);
}

void Builder::disconnected(bool lost) {
  if (lost && !lost_) lost_ = lost_since().value_or(Clock::now());
  open_.put_all_back();
}

Time Builder::own_due() const {
  if (attach_ == Attach::refused) return Time::max();
  if (attach_ == Attach::sent) return next_due_;
  if (hold_until_ > Clock::now()) return std::min(hold_until_, next_due_);
  return next_due_;
}

void Builder::act_joined(Time now) {
  if (worker().finishing()) {
    next_due_ = Time::max();
    due_.clear();
  }
  for (; next_due_ <= now; next_due_ += period_) due_.push_back(next_due_);
  send_due(now);
}

void Builder::send_due(Time now) {
  if (!is_joined() || now < hold_until_) return;
  if (attach_ == Attach::wanted) send_attach();
  if (attach_ != Attach::done) return;
  while (const auto again = open_.send_next()) send_write(*again);
  if (worker().finishing()) return;
  const std::size_t closed = worker().plan().options.edits_in_flight;
  while (has_room() && open_.size() < closed) begin_write(now);
  while (has_room() && !due_.empty()) {
    begin_write(due_.front());
    due_.pop_front();
  }
}

// ---- sending

void Builder::send_view() {
  const VoxelPos at = site_->voxel(place_ * EditSite::kFloor);
  const client::View view = worker().plan().view_at({at.x, site_->voxel(site_->size() / 2).y, at.z}, {});
  send(protocol::make_frame([&](auto& b) {
    const wire::Voxel centre{view.centre.x, view.centre.y, view.centre.z};
    return wire::CreateView(b, &centre, nullptr, view.horizontal_radius, view.vertical_radius);
  }));
}

void Builder::send_attach() {
  attach_ = Attach::sent;
  send(protocol::make_frame([&](auto& b) {
    const wire::Hash128 editor{editor_.low, editor_.high};
    return wire::CreateAttach(b, &editor, seen_revision_);
  }));
}

void Builder::begin_write(Time due) {
  const std::size_t index = place_ * EditSite::kFloor + next_cell_;
  next_cell_ = (next_cell_ + 1) % EditSite::kFloor;
  EditSite::Cell& cell = site_->cell(index);
  cell.written = site_->next(index);
  cell.is_written = cell.open = cell.certain = true;
  cell.due = due;
  cell.server = server();
  (void)open_.add({index, cell.written, due});
  send_write(*open_.send_next());
}

void Builder::send_write(std::uint64_t sequence) {
  const OpenWrite& write = open_.at(sequence);
  const VoxelPos at = site_->voxel(write.cell);
  send(protocol::make_frame([&](auto& b) {
    const std::array writes{wire::VoxelWrite{{at.x, at.y, at.z}, to_integer(write.material)}};
    return wire::CreateEdit(b, OpenWrites::id_of(sequence),
                            b.CreateVectorOfStructs(writes.data(), writes.size()), sequence);
  }));
}

// ---- answers

void Builder::take(const wire::Attached& attached) {
  if (attach_ != Attach::sent || attached.editor() == nullptr || attached.limits() == nullptr) {
    return wrong(tally().bad_messages, "an Attached that no Attach asked for, or without its fields");
  }
  attach_ = Attach::done;
  if (lost_) is_back(*std::exchange(lost_, std::nullopt));
  editor_ = {attached.editor()->low(), attached.editor()->high()};
  seen_revision_ = std::max(seen_revision_, attached.revision());
  // Fewer than its floor's voxels: a voxel is never written again before the answer.
  unanswered_ = std::clamp<std::size_t>(attached.limits()->unanswered(), 1, EditSite::kFloor - 1);
  for (const OpenWrite& lost : open_.attached(attached.known(), attached.last_sequence())) {
    ++tally().edits_unknown;
    forget(lost);
  }
}

void Builder::forget(const OpenWrite& write) {
  EditSite::Cell& cell = site_->cell(write.cell);
  cell.open = false;
  cell.certain = false;
}

void Builder::take(const wire::EditResult& result) {
  const auto sequence = open_.in_flight(result.id());
  if (!sequence) return wrong(tally().outside, "an EditResult for an edit that is not open");
  const OpenWrite write = open_.take(*sequence);
  site_->cell(write.cell).open = false;
  seen_revision_ = std::max(seen_revision_, result.revision());
  ++tally().edits;
  tally().edited_voxels += result.changed();
  if (EditJournal* const journal = worker().plan().journal.get();
      journal != nullptr && result.changed() > 0) {
    journal->add(result.revision(), site_->voxel(write.cell), write.material);
  }
  Live::add(worker().live().edits, 1);
  if (worker().counts(write.due)) tally().edit_ack.record(Clock::now() - write.due);
}

void Builder::take(const wire::Error& error) {
  const Time now = Clock::now();
  const std::chrono::milliseconds wait{error.retry_after_ms()};
  if (tally().first_refused.empty()) tally().first_refused = said(error);
  if (error.about() == wire::ErrorAbout::attach) {
    attach_ = wait.count() > 0 ? Attach::wanted : Attach::refused;
    hold_until_ = now + wait;
    return;
  }
  const auto sequence = open_.in_flight(error.request_id());
  if (!sequence) return;
  if (error.code() == wire::ErrorCode::expired) {
    open_.put_back(*sequence);
    if (attach_ == Attach::done) attach_ = Attach::wanted;
  } else if (error.code() == wire::ErrorCode::not_applied) {
    open_.renew(*sequence);
  } else if (wait.count() > 0) {
    open_.put_back(*sequence);
    hold_until_ = std::max(hold_until_, now + wait);
  } else {
    forget(open_.take(*sequence));
  }
}

// ---- observation

std::optional<std::size_t> Builder::part_of(const wire::ChunkKey* key) const {
  if (key == nullptr || key->lod() != 0) return std::nullopt;
  const auto parts = site_->parts();
  const auto part =
      std::ranges::find(parts, ChunkCoord{key->x(), key->y(), key->z()}, &EditSite::Part::chunk);
  if (part == parts.end()) return std::nullopt;
  return static_cast<std::size_t>(part - parts.begin());
}

void Builder::sees(std::uint32_t cell, MaterialId material, Time now, bool update) {
  const EditSite::Cell& written = site_->cell(cell);
  const bool news = seen_[cell] != material;
  seen_[cell] = material;
  if (!update || !news || !written.is_written || material != written.written) return;
  if (EditSite::builder_of(cell) == place_) return;
  ++tally().edit_arrivals;
  if (!worker().counts(written.due)) return;
  tally().edit_arrival.record(now - written.due);
  if (written.server != server()) tally().edit_other_server.record(now - written.due);
}

void Builder::take(const wire::Chunk& chunk) {
  if (!verify(chunk)) return;
  const auto part = part_of(chunk.key());
  if (!part) return;
  std::optional<std::uint64_t>& held = revisions_[*part];
  if (held && *held >= chunk.revision()) return;
  const auto decoded = decode(std::as_bytes(std::span{chunk.payload()->data(), chunk.payload()->size()}));
  if (!decoded)
    return wrong(tally().bad_chunks, fmt::format("a chunk cannot be decoded: {}", describe(decoded.error())));
  const Time now = Clock::now();
  DenseVoxels voxels;
  decoded->copy_to(voxels);
  for (const auto& [index, cell] : site_->parts()[*part].cells)
    sees(cell, voxels[index], now, held.has_value());
  held = chunk.revision();
}

void Builder::take(const wire::UniformColumn& column) {
  if (column.runs() == nullptr) return;
  for (const wire::UniformRun* run : *column.runs()) {
    for (std::size_t part = 0; part < site_->parts().size(); ++part) {
      const auto& [chunk, cells] = site_->parts()[part];
      if (column.lod() != 0 || chunk.x != column.x() || chunk.z != column.z()) continue;
      if (chunk.y < run->first_y() || chunk.y > run->last_y() || revisions_[part]) continue;
      for (const auto& [index, cell] : cells) seen_[cell] = MaterialId{run->material()};
      revisions_[part] = 0;
    }
  }
}

void Builder::take(const wire::EditBroadcast& broadcast) {
  const auto part = part_of(broadcast.key());
  if (!part) return;  // another level, or an edit by others nearby
  std::optional<std::uint64_t>& held = revisions_[*part];
  if (!held) return wrong(tally().outside, "an EditBroadcast of a chunk that was not sent");
  if (broadcast.revision() <= *held) return;
  if (broadcast.previous_revision() > *held) {
    return wrong(tally().bad_messages,
                 fmt::format("an EditBroadcast from revision {} on, of a chunk sent at {}",
                             broadcast.previous_revision(), *held));
  }
  const auto voxels =
      broadcast.runs() == nullptr
          ? edits::decode_runs({})
          : edits::decode_runs(std::as_bytes(std::span{broadcast.runs()->data(), broadcast.runs()->size()}));
  if (!voxels) return wrong(tally().bad_messages, "an EditBroadcast with invalid runs");
  const Time now = Clock::now();
  const auto& cells = site_->parts()[*part].cells;
  for (const Override& voxel : *voxels) {
    const auto cell =
        std::ranges::lower_bound(cells, voxel.index, {}, &std::pair<std::uint16_t, std::uint32_t>::first);
    if (cell != cells.end() && cell->first == voxel.index) sees(cell->second, voxel.material, now, true);
  }
  held = broadcast.revision();
}

std::size_t Builder::missing() const {
  std::size_t missing = 0;
  for (std::size_t index = 0; index < site_->size(); ++index) {
    const EditSite::Cell& cell = site_->cell(index);
    if (cell.settled() && seen_[index] != cell.written) ++missing;
  }
  return missing;
}

bool Builder::satisfied() const {
  if (attach_ == Attach::refused) return true;
  return open_.empty() && (!is_joined() || missing() == 0);
}

void Builder::give_up() {
  for (std::size_t i = 0; i < open_.size(); ++i) never_came("the answer to an edit");
  if (const std::size_t count = is_joined() ? missing() : 0; count > 0) {
    const auto first = [&] {
      for (std::size_t index = 0; index < site_->size(); ++index) {
        const EditSite::Cell& cell = site_->cell(index);
        if (cell.settled() && seen_[index] != cell.written) return index;
      }
      return std::size_t{0};
    }();
    const VoxelPos at = site_->voxel(first);
    tally().edits_missing += count;
    if (tally().first_missing.empty()) {
      tally().first_missing = fmt::format(
          "{} {} has {} at {},{},{}, but an edit to {} was acknowledged", name_of(role()), profile().number,
          seen_[first] ? fmt::format("material {}", to_integer(*seen_[first])) : "nothing yet", at.x, at.y,
          at.z, to_integer(site_->cell(first).written));
    }
  }
}

}  // namespace talus::load
