#include "commands/store/history_report.h"

#include <algorithm>
#include <ranges>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "commands/store/moments.h"
#include "commands/store/reports.h"
#include "commands/store/subjects.h"

namespace talus::server {
namespace {

using HistoryJson = nlohmann::ordered_json;

/// Maximum number of other subjects listed if the requested one is not found.
constexpr std::size_t kNamedOthers = 20;

/// Prints text in pages, hiding the progress bar meanwhile.
class Pages {
 public:
  Pages(const Print& print, ProgressBar& progress) : print_{print}, progress_{progress} {}

  void add(std::string_view text) {
    text_ += text;
    if (text_.size() >= kPageBytes) flush();
  }
  void flush() {
    if (text_.empty()) return;
    progress_.clear();
    print_(text_);
    text_.clear();
  }

 private:
  const Print& print_;
  ProgressBar& progress_;
  std::string text_;
};

/// A JSON object with one list, whose items are written as they arrive.
class JsonPages {
 public:
  explicit JsonPages(Pages& pages) : pages_{pages} {}

  void begin(const HistoryJson& fields, std::string_view list) {
    std::string text = "{\n";
    for (const auto& [name, value] : fields.items()) {
      text += fmt::format("  {}: {},\n", HistoryJson(name).dump(), value.dump());
    }
    pages_.add(fmt::format("{}  \"{}\": [", text, list));
  }
  void item(const HistoryJson& item) {
    pages_.add((std::exchange(first_, false) ? "\n    " : ",\n    ") + item.dump());
  }
  void end(const HistoryJson& fields) {
    std::string text = first_ ? "]" : "\n  ]";
    for (const auto& [name, value] : fields.items()) {
      text += fmt::format(",\n  {}: {}", HistoryJson(name).dump(), value.dump());
    }
    pages_.add(text + "\n}\n");
  }

 private:
  Pages& pages_;
  bool first_ = true;
};

/// An editor's id is a secret; this part distinguishes editors.
std::string short_id(edits::EditorId id) {
  return fmt::format("{:08x}", id.high >> 32U);
}

std::string json_subject(std::string_view subject) {
  return subject.empty() ? "" : subject_text(subject);
}

std::string kept_line(const KeptRecords& kept) {
  if (kept.any()) {
    return fmt::format("records go back to entry {}, at {}\n", kept.first, moment(kept.first_time_ms));
  }
  if (kept.last == 0) return "no records are kept: the store has no edits yet\n";
  return fmt::format(
      "no records up to entry {}, the last, are kept; a store that was imported or rebased begins without "
      "records\n",
      kept.last);
}

HistoryJson kept_json(const KeptRecords& kept) {
  HistoryJson json = HistoryJson::object();
  json["first_position"] = kept.any() ? HistoryJson(kept.first) : HistoryJson();
  json["first_time"] = kept.any() ? HistoryJson(moment(kept.first_time_ms)) : HistoryJson();
  return json;
}

std::string others_line(const SubjectQuery& query, const SubjectSummary& summary) {
  std::string named;
  for (const auto& [subject, edits] : summary.others | std::views::take(kNamedOthers)) {
    named +=
        fmt::format("{}{} ({})", named.empty() ? "" : ", ", subject_text(subject), counted(edits, "edit"));
  }
  if (summary.more_others) {
    named += fmt::format(", and over {} more", summary.others.size() - kNamedOthers);
  } else if (summary.others.size() > kNamedOthers) {
    named += fmt::format(", and {} more", summary.others.size() - kNamedOthers);
  }
  return fmt::format("no entries of subject {}; {}\n", subject_text(query.subject),
                     named.empty() ? "nor of any other" : "subjects with entries: " + named);
}

std::string edit_line(const SubjectEdit& edit) {
  const VoxelPos& first = edit.first;
  const VoxelPos& last = edit.last;
  return fmt::format("{}  {} in {},{},{}:{},{},{}  editor {}, entry {}, revision {}\n", moment(edit.time_ms),
                     counted(edit.voxels, "voxel"), first.x, first.y, first.z, last.x, last.y, last.z,
                     short_id(edit.editor), edit.position, edit.revision);
}

HistoryJson edit_json(const SubjectEdit& edit) {
  return {{"time", moment(edit.time_ms)},
          {"time_ms", edit.time_ms},
          {"voxels", edit.voxels},
          {"first", {edit.first.x, edit.first.y, edit.first.z}},
          {"last", {edit.last.x, edit.last.y, edit.last.z}},
          {"editor", short_id(edit.editor)},
          {"position", edit.position},
          {"revision", edit.revision}};
}

std::string change_line(const VoxelHistory& change, const MaterialNames& names) {
  return fmt::format("{}  {} -> {}  {}  editor {}, revision {}\n", moment(change.time_ms),
                     names.of(change.before), names.of(change.after), subject_text(change.subject),
                     short_id(change.editor), change.revision);
}

HistoryJson change_json(const VoxelHistory& change, const MaterialNames& names) {
  return {{"time", moment(change.time_ms)},
          {"time_ms", change.time_ms},
          {"before", names.of(change.before)},
          {"after", names.of(change.after)},
          {"subject", json_subject(change.subject)},
          {"editor", short_id(change.editor)},
          {"position", change.position},
          {"revision", change.revision}};
}

HistoryJson others_json(const SubjectSummary& summary) {
  HistoryJson others = HistoryJson::array();
  for (const auto& [subject, edits] : summary.others | std::views::take(kNamedOthers)) {
    others.push_back({{"subject", json_subject(subject)}, {"edits", edits}});
  }
  return others;
}

}  // namespace

tl::expected<void, std::string> print_history(const store::ReadOnlyStore& store, VoxelPos voxel, bool json,
                                              const Print& print) {
  const auto kept = kept_records(store);
  if (!kept) return tl::unexpected{kept.error()};
  const MaterialNames names{store.materials()};
  ProgressBar progress{"history", "entries"};
  Pages pages{print, progress};
  JsonPages document{pages};
  if (json) {
    document.begin(kept_json(*kept), "changes");
  } else {
    pages.add(kept_line(*kept));
  }
  bool any = false;
  const auto read = history_of(
      store, voxel,
      [&](const VoxelHistory& change) {
        any = true;
        if (json) {
          document.item(change_json(change, names));
        } else {
          pages.add(change_line(change, names));
        }
      },
      progress);
  if (!read) return read;
  if (json) {
    document.end({});
  } else if (!any && kept->any()) {
    pages.add("the voxel has not changed since\n");
  }
  pages.flush();
  return {};
}

tl::expected<void, std::string> print_history(const store::ReadOnlyStore& store, const SubjectQuery& query,
                                              bool json, const Print& print) {
  const auto kept = kept_records(store);
  if (!kept) return tl::unexpected{kept.error()};
  ProgressBar progress{"history", "entries"};
  Pages pages{print, progress};
  JsonPages document{pages};
  if (json) {
    HistoryJson fields = kept_json(*kept);
    fields["subject"] = json_subject(query.subject);
    document.begin(fields, "edits");
  } else {
    pages.add(kept_line(*kept));
  }
  const auto read = subject_history(
      store, query,
      [&](const SubjectEdit& edit) {
        if (json) {
          document.item(edit_json(edit));
        } else {
          pages.add(edit_line(edit));
        }
      },
      progress);
  if (!read) return tl::unexpected{read.error()};
  if (json) {
    HistoryJson fields = {{"more", read->more}};
    if (!read->met) fields["subjects"] = others_json(*read);
    document.end(fields);
  } else if (!read->met) {
    pages.add(others_line(query, *read));
  } else if (read->listed == 0) {
    pages.add(fmt::format("{} has changed no voxel since {}{}\n", subject_text(query.subject),
                          moment(std::max(query.since_ms, kept->first_time_ms)),
                          query.after == 0 ? "" : fmt::format(", after entry {}", query.after)));
  } else if (read->more) {
    pages.add(fmt::format("there are more: --after {}\n", read->last_position));
  }
  pages.flush();
  return {};
}

}  // namespace talus::server
