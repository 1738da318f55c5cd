#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include <talus/protocol/header_fields.h>

using namespace talus::protocol;

TEST_CASE("names are the same in any case, of ASCII alone") {
  CHECK(same_name("X-Forwarded-For", "x-forwarded-FOR"));
  CHECK(same_name("", ""));
  CHECK_FALSE(same_name("Host", "Hosts"));
  CHECK_FALSE(same_name("[", "{"));  // as far apart as "A" and "a"
  CHECK_FALSE(same_name("\xC4", "\xE4"));
}

TEST_CASE("spaces and tabs around a value are not part of it") {
  CHECK(trimmed(" \t a b\t ") == "a b");
  CHECK(trimmed("a") == "a");
  CHECK(trimmed(" \t").empty());
  CHECK(trimmed("").empty());
  CHECK(trimmed("\ra\n") == "\ra\n");
}

TEST_CASE("a list gives its items in their order, each once") {
  const auto items = [](std::string_view list) {
    std::vector<std::string> all;
    while (!list.empty()) all.emplace_back(take_item(list));
    return all;
  };
  CHECK(items("a") == std::vector<std::string>{"a"});
  CHECK(items(" a ,\tb;q=0.5 ,, c") == std::vector<std::string>{"a", "b;q=0.5", "", "c"});
  CHECK(items("").empty());
}

TEST_CASE("a word is found in a list only whole") {
  CHECK(has_word("keep-alive, Upgrade", "upgrade"));
  CHECK(has_word("websocket", "WebSocket"));
  CHECK_FALSE(has_word("keep-alive, Upgrades", "upgrade"));
  CHECK_FALSE(has_word("keep-alive upgrade", "upgrade"));
  CHECK_FALSE(has_word("", "upgrade"));
}
