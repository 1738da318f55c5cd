// Where a client's token comes from.
#include "token.h"

#include <stdlib.h>

#include <catch2/catch.hpp>

#include "command_line.h"
#include "scratch_directory.h"

namespace talus::cli {
namespace {

/// A variable for as long as a test needs it.
class Variable {
 public:
  Variable(const char* name, const std::string& value) : name_{name} { ::setenv(name, value.c_str(), 1); }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;
  ~Variable() { ::unsetenv(name_); }

 private:
  const char* name_;
};

std::string token(std::vector<const char*> words) {
  words.insert(words.begin(), {"talus-client"});
  words.insert(words.end(), {"get", "0", "0", "0"});
  const auto line = read_command_line(static_cast<int>(words.size()), words.data());
  REQUIRE(line.has_value());
  return line->connecting.options.token;
}

}  // namespace

TEST_CASE("a token comes from a file, a word or a variable, and flags win") {
  const ScratchDirectory scratch;
  const std::string file = scratch.write("token", "from a file\r\n");
  CHECK(token({}).empty());
  CHECK(token({"--token-file", file.c_str()}) == "from a file");
  CHECK(token({"--token", "a word"}) == "a word");
  const Variable of_file{"TALUS_TOKEN_FILE", file};
  CHECK(token({}) == "from a file");
  const Variable variable{"TALUS_TOKEN", "a variable"};
  CHECK(token({}) == "a variable");
  CHECK(token({"--token", "a word"}) == "a word");
  CHECK(token({"--token-file", file.c_str()}) == "from a file");
}

TEST_CASE("a token file that is none is one line") {
  const ScratchDirectory scratch;
  for (const std::string& file :
       {std::string{"/nowhere"}, scratch.path().string(), scratch.write("empty", "\n"),
        scratch.write("long", std::string(4097, 'x'))}) {
    const auto none = token_of({{}, file});
    REQUIRE_FALSE(none.has_value());
    CHECK_THAT(none.error(), Catch::StartsWith("--token-file " + file + ": ") && !Catch::Contains("\n"));
  }
  CHECK(token_of({{}, scratch.write("longest", std::string(4096, 'x') + "\n")})->size() == 4096);
}

}  // namespace talus::cli
