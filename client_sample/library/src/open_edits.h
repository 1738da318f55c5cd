// Unanswered edits: under which editor they are sent, and when they are sent again. No I/O.
//
// An edit gets its sequence number when it is first sent. Edits sent again, after a reconnect or because the
// server refused them temporarily, go first, in order and with their number: the server answers with their
// outcome and applies none twice. If the answer is that the edit was not applied but a later one was, it is
// sent as a new edit.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <vector>

#include <talus/client/client.h>
#include <talus/edits/editors.h>

namespace talus::client {

struct OpenEdit {
  Edit edit;
  std::function<void(Result<EditDone>)> handler;
  std::uint64_t sequence = 0;  // 0: never sent
  bool sent_before = false;    // and not known to be unapplied
};

class OpenEdits {
 public:
  /// Set in ids of edits, clear in ids of other requests.
  static constexpr std::uint32_t kIdBit = 0x8000'0000;

  enum class Attach : std::uint8_t { none, sent, done };

  void add(OpenEdit edit) { waiting_.push_back(std::move(edit)); }
  [[nodiscard]] bool empty() const { return waiting_.empty() && again_.empty() && in_flight_.empty(); }

  // ---- editor
  /// False while edits of the old editor are in flight: they are answered first.
  [[nodiscard]] bool must_attach() const { return attach_ == Attach::none && in_flight_.empty() && !empty(); }
  [[nodiscard]] bool attaching() const { return attach_ == Attach::sent; }
  [[nodiscard]] edits::EditorId editor() const { return editor_; }
  [[nodiscard]] std::uint64_t seen_revision() const { return seen_revision_; }
  void saw(std::uint64_t revision) { seen_revision_ = std::max(seen_revision_, revision); }
  void attach_sent() { attach_ = Attach::sent; }
  /// The server asked to retry later: Attach must be sent again.
  void attach_again() { attach_ = Attach::none; }
  /// Another connection took over the editor. The first of the rejected edits triggers an Attach.
  void editor_expired() {
    if (attach_ == Attach::done) attach_ = Attach::none;
  }
  /// Returns edits whose outcome can never be known: they were sent as an editor that the server no longer
  /// knows.
  [[nodiscard]] std::vector<OpenEdit> attached(edits::EditorId editor, bool known,
                                               std::uint64_t last_sequence, std::uint64_t revision,
                                               std::uint32_t unanswered);
  /// Drops the editor, after the server changed its store. Returns the edits already sent.
  [[nodiscard]] std::vector<OpenEdit> forget_editor();

  // ---- sending
  [[nodiscard]] bool has_next() const {
    return attach_ == Attach::done && in_flight_.size() < unanswered_ &&
           !(again_.empty() && waiting_.empty());
  }
  /// Marks the next edit as in flight and returns its id. REQUIRES: has_next().
  [[nodiscard]] std::uint32_t send_next();
  /// Null if no edit in flight has the id.
  [[nodiscard]] const OpenEdit* in_flight(std::uint32_t id) const;
  /// Removes an answered edit.
  [[nodiscard]] OpenEdit take(std::uint32_t id);
  /// To be sent again with its sequence number: it may have been applied.
  void put_back(std::uint32_t id);
  /// Was not applied, and must be: sent before edits never sent, in order among the edits put back here.
  void send_as_new(std::uint32_t id);

  /// The connection broke.
  void connection_ended();
  struct All {
    std::vector<OpenEdit> sent;  // outcome unknown
    std::vector<OpenEdit> unsent;
  };
  [[nodiscard]] All take_all();

 private:
  [[nodiscard]] std::vector<OpenEdit> take_sent();

  Attach attach_ = Attach::none;
  edits::EditorId editor_;
  std::uint64_t last_sequence_ = 0;
  std::uint64_t seen_revision_ = 0;
  std::uint32_t unanswered_ = 1;  // maximum

  std::deque<OpenEdit> waiting_;                 // never sent, or to be sent as new
  std::map<std::uint64_t, OpenEdit> again_;      // sent by an earlier connection, by sequence
  std::map<std::uint32_t, OpenEdit> in_flight_;  // by id
  std::uint32_t last_id_ = 0;
};

}  // namespace talus::client
