#include "app/reload.h"

#include <cassert>

#include <fmt/format.h>

#include "runtime/log/escape.h"

namespace talus::server {
namespace {

/// Numbers and "auto" unquoted, other values in quotes.
std::string value_shown(const Field& field, const Config& config) {
  const std::string text = on_one_line(text_of(field, config));
  return is_number(field) ? text : fmt::format("\"{}\"", text);
}

std::string_view when_it_counts(Counts counts) {
  switch (counts) {
    case Counts::at_once:
      return "";
    case Counts::for_new_sessions:
      return ", for new sessions";
    case Counts::after_restart:
      break;
  }
  return " needs a restart; until then the old value counts";
}

}  // namespace

std::vector<SettingChange> changes_between(const Config& before, const Config& after) {
  std::vector<SettingChange> changes;
  for (const Field& field : fields()) {
    const std::string from = value_shown(field, before);
    const std::string to = value_shown(field, after);
    if (from == to) continue;
    changes.push_back(
        {fmt::format("{}: {} -> {}{}", field.key, from, to, when_it_counts(counts(field))), counts(field)});
  }
  return changes;
}

Config changed_while_running(const Config& before, const Config& after) {
  Config changed = before;
  for (const Field& field : fields()) {
    if (counts(field) == Counts::after_restart) continue;
    [[maybe_unused]] const auto set = set_from_text(field, changed, text_of(field, after));
    assert(set.has_value());  // text_of() and set_from_text() are inverses
  }
  return changed;
}

}  // namespace talus::server
