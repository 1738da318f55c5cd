// What `talusd store history` calls a subject is what `rollback --subject` takes.
#include <filesystem>
#include <random>
#include <set>
#include <string>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <talus/store/data_directory.h>

#include "commands/store/history_report.h"
#include "commands/store/store_command.h"
#include "commands/store/subjects.h"
#include "edits_of_tests.h"
#include "runtime/log/escape.h"
#include "scratch_directory.h"

namespace talus::server {
namespace {

using namespace testing;

int run_store_command(std::vector<const char*> flags) {
  flags.insert(flags.begin(), "store");
  const LoadWorld none = [](const std::filesystem::path&, const SecretLayers&) {
    return tl::expected<std::shared_ptr<const terrain::World>, std::string>{tl::unexpect, "no world"};
  };
  return store_command(static_cast<int>(flags.size()), flags.data(), {}, none, {});
}

}  // namespace

TEST_CASE("subjects are shown as they are if all characters are visible, and other bytes as \\xNN") {
  struct {
    std::string subject;
    std::string text;
  } const cases[] = {
      {"alice", "alice"},
      {"Jürgen Müller", "Jürgen Müller"},
      {"名前 \"🙂\"", "名前 \"🙂\""},
      {"", "(no token)"},
      {"(no token)", "\\x28no token)"},
      {"(no tokens)", "(no tokens)"},
      {"a\\x41", "a\\x5cx41"},
      {"a\nb\x1b[1m", "a\\x0ab\\x1b[1m"},
      {"\xff\xc3(", "\\xff\\xc3("},
      {" a  b ", "\\x20a \\x20b\\x20"},
      {"a\u202eb\u00a0c\ufeff", "a\\xe2\\x80\\xaeb\\xc2\\xa0c\\xef\\xbb\\xbf"},
      {"a\U000E0041", "a\\xf3\\xa0\\x81\\x81"},
  };
  for (const auto& [subject, text] : cases) {
    CHECK(subject_text(subject) == text);
    CHECK(parse_subject(text) == subject);
  }
}

TEST_CASE("a subject's text is unique, on one line, and read back, whatever its bytes") {
  std::mt19937_64 random{20260131};
  std::set<std::string> texts;
  std::set<std::string> subjects;
  const std::string some = "a \\()x5c\xc3\xa9\xe2\x80\xae\n";
  for (int i = 0; i < 50'000; ++i) {
    std::string subject(random() % 12, ' ');
    for (char& byte : subject)
      byte = random() % 2 == 0 ? some[random() % some.size()] : static_cast<char>(random());
    const std::string text = subject_text(subject);
    if (on_one_line(text) != text) FAIL(text << " is not on one line");
    if (parse_subject(text) != subject) FAIL(text << " is read as something else");
    texts.insert(text);
    subjects.insert(subject);
  }
  CHECK(texts.size() == subjects.size());
}

TEST_CASE("a subject may be given with its other bytes as \\xNN too, but no half a byte") {
  CHECK(parse_subject("\\x61\\x6Cice") == "alice");
  CHECK(parse_subject("J\xfcrgen") == "J\xfcrgen");
  CHECK(parse_subject("") == "");
  for (const char* const wrong : {"\\", "a\\x", "\\x4", "\\xg1", "\\x1g", "\\X41", "\\n", "\\x-1", "\\x+1"}) {
    const auto refused = parse_subject(wrong);
    REQUIRE_FALSE(refused.has_value());
    CHECK(refused.error() ==
          "\"" + std::string{wrong} +
              "\" has a backslash that begins no byte as \\xNN; write a backslash as \\x5c");
  }
}

TEST_CASE("a subject as history prints it selects its edits for a rollback") {
  const std::string subject = GENERATE(as<std::string>{}, "", "J\u00fcrgen \\ \"M\"", "\xff\n (no token)");
  const ScratchDirectory scratch{ScratchDirectory::memory()};
  const std::string path = scratch / "data";
  const VoxelPos at{1, 2, 3};
  {
    const auto directory = store::DataDirectory::open(path, {1, 2});
    REQUIRE(directory.has_value());
    EditStore store{path};
    store.database_settings.store_id = directory->store_id();
    REQUIRE(store.open() == "");
    TestEditor editor;
    editor.id = {7, 7};
    editor.epoch = 1;
    REQUIRE(store.apply(edits::AttachEntry{editor.id, 1, subject})->kind ==
            edits::EntryResult::Kind::attached);
    edits::Edit edit;
    edit.writes.push_back({at, MaterialId{9}});
    REQUIRE(editor.edit(store, edit)->result.changed == 1);
  }
  const auto history = [&](bool json) {
    const auto store = store::ReadOnlyStore::open(path);
    REQUIRE(store.has_value());
    std::string text;
    REQUIRE(print_history(**store, at, json, [&](std::string_view page) { text += page; }));
    return text;
  };
  const auto changes = [&] { return nlohmann::json::parse(history(true)).at("changes"); };
  const std::string shown = changes().at(0).at("subject");
  CHECK_THAT(history(false), Catch::Contains("  " + subject_text(subject) + "  editor"));
  const auto rollback = [&](const std::string& named) {
    return run_store_command({"rollback", "--data", path.c_str(), "--subject", named.c_str(), "--since", "1h",
                              "--box", "0,0,0,9,9,9"});
  };
  CHECK(rollback("somebody else") == 0);
  CHECK(changes().size() == 1);
  CHECK(rollback(shown) == 0);
  REQUIRE(changes().size() == 2);
  CHECK(changes().at(1).at("after") == changes().at(0).at("before"));
}

}  // namespace talus::server
