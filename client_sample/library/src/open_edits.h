// Edits that have no answer yet, as which editor they are sent, and what is sent again when. No I/O.
//
// An edit gets its sequence when it is first sent. What is sent again, after a new connection or as the
// server refused it for now, goes first, in order and with its sequence: the server answers by what became of
// it, and does none twice. Where it says that the edit did not happen, and a later one did, it goes as a new
// one.
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
  bool sent_before = false;    // and not known since not to have happened
};

class OpenEdits {
 public:
  /// Ids of edits have this bit, those of other requests do not.
  static constexpr std::uint32_t kIdBit = 0x8000'0000;

  enum class Attach : std::uint8_t { none, sent, done };

  void add(OpenEdit edit) { waiting_.push_back(std::move(edit)); }
  [[nodiscard]] bool empty() const { return waiting_.empty() && again_.empty() && in_flight_.empty(); }

  // ---- as which editor
  /// Not while the old editor's edits are in flight: they are answered first.
  [[nodiscard]] bool must_attach() const { return attach_ == Attach::none && in_flight_.empty() && !empty(); }
  [[nodiscard]] bool attaching() const { return attach_ == Attach::sent; }
  [[nodiscard]] edits::EditorId editor() const { return editor_; }
  [[nodiscard]] std::uint64_t seen_revision() const { return seen_revision_; }
  void saw(std::uint64_t revision) { seen_revision_ = std::max(seen_revision_, revision); }
  void attach_sent() { attach_ = Attach::sent; }
  /// The server asked to come back: Attach once more.
  void attach_again() { attach_ = Attach::none; }
  /// Another connection took the editor. Of several edits that are told so the first has an Attach sent.
  void editor_expired() {
    if (attach_ == Attach::done) attach_ = Attach::none;
  }
  /// Returns the edits of which nobody will ever say whether they happened: they were sent as an editor that
  /// the server does not know any more.
  [[nodiscard]] std::vector<OpenEdit> attached(edits::EditorId editor, bool known,
                                               std::uint64_t last_sequence, std::uint64_t revision,
                                               std::uint32_t unanswered);
  /// Another store: nothing is left of the editor, nor of its edits. Returns those that were sent.
  [[nodiscard]] std::vector<OpenEdit> forget_editor();

  // ---- what to send
  [[nodiscard]] bool has_next() const {
    return attach_ == Attach::done && in_flight_.size() < unanswered_ &&
           !(again_.empty() && waiting_.empty());
  }
  /// The next one, in flight from now on under the returned id. REQUIRES: has_next().
  [[nodiscard]] std::uint32_t send_next();
  /// Null: none in flight has the id.
  [[nodiscard]] const OpenEdit* in_flight(std::uint32_t id) const;
  /// It is answered.
  [[nodiscard]] OpenEdit take(std::uint32_t id);
  /// It is to be sent again as it is: it may have happened.
  void put_back(std::uint32_t id);
  /// It did not happen, and shall: before those never sent, and in order among those that were put there.
  void send_as_new(std::uint32_t id);

  /// The connection broke.
  void connection_ended();
  struct All {
    std::vector<OpenEdit> sent;  // of which nobody knows whether they happened
    std::vector<OpenEdit> unsent;
  };
  [[nodiscard]] All take_all();

 private:
  [[nodiscard]] std::vector<OpenEdit> take_sent();

  Attach attach_ = Attach::none;
  edits::EditorId editor_;
  std::uint64_t last_sequence_ = 0;
  std::uint64_t seen_revision_ = 0;
  std::uint32_t unanswered_ = 1;  // at most

  std::deque<OpenEdit> waiting_;                 // never sent, or to be sent as new
  std::map<std::uint64_t, OpenEdit> again_;      // sent by an earlier connection, by sequence
  std::map<std::uint32_t, OpenEdit> in_flight_;  // by id
  std::uint32_t last_id_ = 0;
};

}  // namespace talus::client
