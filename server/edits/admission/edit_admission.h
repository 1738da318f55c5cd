// Decides, on a session's thread, whether its client may attach as an editor and whether an edit may go to
// the log.
//
// Two stages follow, which need what is known later: EditIntake checks the bounds of the world when it
// prepares an edit, and admit_to_log() bounds of memory when the log accepts it. The extent of an edit is
// computed here, once: rates, turns, settling and the store use this one.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <tl/expected.hpp>

#include "chunks/chunk_source.h"
#include "config/access/grant.h"
#include "edits/admission/edit_rules.h"
#include "edits/admission/wire_edit.h"
#include "edits/edit_taker.h"
#include "limits/memory/memory_budget.h"
#include "limits/rates/rates.h"

namespace talus::server {

/// A session that asks, as it is when the message arrives.
struct EditingSession {
  const Grant& grant;
  FlowId flow{};
  Clock::time_point now{};
  bool leaving = false;
  bool attached = false;
  edits::EditorId editor{};  // 0 unless attached
  std::size_t unanswered = 0;
};

struct AdmittedAttach {
  AttachRequest request;
  bool makes_editor = false;  // which the rates of the address count
};

/// Owned by one session.
class EditAdmission {
 public:
  /// Maximum chunks remembered as paid: enough for two edits, as the second may come before the first is
  /// applied.
  static constexpr std::size_t kMaxPaid = 2 * edits::kMaxChunks;

  /// All outlive this. `taker` is null if nothing is stored.
  struct Parts {
    const EditRules& rules;
    const ChunkSource& chunks;
    MemoryBudget& memory;
    const EditTaker* taker;
  };
  explicit EditAdmission(const Parts& parts) : parts_{parts} {}

  [[nodiscard]] tl::expected<AdmittedAttach, EditError> admit(const wire::Attach& attach,
                                                              const EditingSession& session) const;
  /// EditErrorCode::malformed ends the connection.
  [[nodiscard]] tl::expected<AdmittedEdit, EditError> admit(const wire::Edit& edit,
                                                            const EditingSession& session) const;

  /// Charges an admitted edit to the rates: its voxels, and its chunks that were never edited, however few
  /// voxels it writes or guards there, or may reveal, because the server has to generate each and may keep it
  /// in its index for ever. A session pays for such a chunk once while it is among the last kMaxPaid,
  /// whatever becomes of the edit. nullopt if granted.
  [[nodiscard]] std::optional<SessionRates::Refusal> charge(const AdmittedEdit& edit, SessionRates& rates,
                                                            SessionRates::Time now);

  /// Memory in addition to the object itself.
  [[nodiscard]] std::size_t bytes() const { return paid_.capacity() * sizeof(ChunkCoord); }

 private:
  [[nodiscard]] tl::expected<void, EditError> admit(const EditingSession& session) const;

  const Parts parts_;
  std::vector<ChunkCoord> paid_;  // newest last until it is full, then a ring
  std::size_t oldest_ = 0;
};

}  // namespace talus::server
