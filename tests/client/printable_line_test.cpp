// Texts of servers are UTF-8 whatever bytes came.
#include "printable_line.h"

#include <catch2/catch.hpp>

namespace talus::client {

TEST_CASE("a text keeps its characters, and control characters become spaces") {
  CHECK(printable_line("", 300).empty());
  CHECK(printable_line("Gr\xC3\xBC\xC3\x9F"
                       "e\n\x7F \xE2\x82\xAC \xF0\x9F\x8F\x94",
                       300) ==
        "Gr\xC3\xBC\xC3\x9F"
        "e   \xE2\x82\xAC \xF0\x9F\x8F\x94");
}

TEST_CASE("invalid characters are replaced one by one") {
  const std::string none{"\xEF\xBF\xBD"};
  CHECK(printable_line("a\xFF"
                       "b",
                       300) == "a" + none + "b");
  CHECK(printable_line("\x80", 300) == none);
  CHECK(printable_line("\xC3", 300) == none);                                // its end is missing
  CHECK(printable_line("\xC0\xAF", 300) == none + none);                     // longer than need be
  CHECK(printable_line("\xE0\x80\xAF", 300) == none + none + none);          // alike
  CHECK(printable_line("\xED\xA0\x80", 300) == none + none + none);          // a surrogate
  CHECK(printable_line("\xF4\x90\x80\x80", 300).size() == 4 * none.size());  // beyond U+10FFFF
  CHECK(printable_line("\xE2\x82z", 300) == none + none + "z");
}

TEST_CASE("a long text is cut between characters") {
  CHECK(printable_line("abcd", 3) == "abc");
  CHECK(printable_line("ab\xC3\xBC", 3) == "ab");
  CHECK(printable_line("ab\xC3\xBC", 4) == "ab\xC3\xBC");
  CHECK(printable_line("ab\xFF", 4) == "ab");
  CHECK(printable_line("a\xC3\xBC"
                       "b",
                       2) == "a");
}

}  // namespace talus::client
