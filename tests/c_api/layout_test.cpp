// The binary interface: what a compiled program has built into it.
#include "layout.h"

#include <catch2/catch.hpp>
#include <cstring>
#include <set>
#include <string>

#include <talus.h>

TEST_CASE("fields and numbers are where version 1.0 promised them to C") {
  for (const layout_entry* entry = layout; entry->name != nullptr; ++entry) {
    INFO(entry->name);
    CHECK(entry->found == entry->promised);
  }
}

TEST_CASE("C++ lays the structs out as C does") {
  const auto found = [](const std::string& name) {
    const layout_entry* entry = layout;
    while (name != entry->name) ++entry;
    return static_cast<std::size_t>(entry->found);
  };
  CHECK(sizeof(talus_connect_options) == found("sizeof talus_connect_options"));
  CHECK(sizeof(talus_view) == found("sizeof talus_view"));
  CHECK(sizeof(talus_world) == found("sizeof talus_world"));
  CHECK(sizeof(talus_material) == found("sizeof talus_material"));
  CHECK(sizeof(talus_stats) == found("sizeof talus_stats"));
  CHECK(sizeof(talus_edit) == found("sizeof talus_edit"));
  CHECK(sizeof(talus_event) == found("sizeof talus_event"));
}

TEST_CASE("the library says its versions") {
  CHECK(talus_api_version() == (TALUS_API_MAJOR << 16 | TALUS_API_MINOR));
  CHECK(std::string{talus_version()}.find('.') != std::string::npos);
}

TEST_CASE("every status has its own name") {
  std::set<std::string> names;
  for (talus_status status = -64; status <= 8; ++status) {
    const std::string name = talus_status_name(status);
    if (name != "unknown status") CHECK(names.insert(name).second);
  }
  CHECK(names.size() == 30);
  CHECK(std::string{talus_status_name(TALUS_REFUSED)} == "TALUS_REFUSED");
  CHECK(std::string{talus_status_name(-52)} == "TALUS_OTHER_SAVE");
}
