// Where results cannot go, a command says so before it connects.
#include "output.h"

#include <asio/co_spawn.hpp>
#include <asio/io_context.hpp>
#include <catch2/catch.hpp>

#include "commands.h"
#include "scratch_directory.h"

using namespace talus;
using namespace talus::cli;

namespace {

// Nobody listens on that port: a command that connects fails by that.
const ConnectTarget kNowhere{{"127.0.0.1", 1}, {}};

std::string error_of(asio::awaitable<CommandResult> command) {
  asio::io_context io;
  CommandResult result;
  asio::co_spawn(io, std::move(command),
                 [&](const std::exception_ptr&, CommandResult ended) { result = std::move(ended); });
  io.run();
  REQUIRE_FALSE(result.has_value());
  return result.error();
}

}  // namespace

TEST_CASE("a file in a folder that is there may be written, and no file at all") {
  const ScratchDirectory scratch;
  CHECK(check_output(scratch.path() / "view.png").has_value());
  CHECK(check_output("view.png").has_value());
  CHECK(check_output({}).has_value());
  CHECK_THAT(check_output(scratch.path() / "missing" / "view.png").error(),
             Catch::Contains("missing/view.png: cannot be written: No such file or directory"));
}

TEST_CASE("commands look at their files before they connect") {
  const std::filesystem::path missing = "/no/such/folder/result";
  const auto says_so = Catch::StartsWith("/no/such/folder/result: cannot be written");
  FlyOptions view;
  view.view = missing;
  CHECK_THAT(error_of(fly(kNowhere, view)), says_so);
  FlyOptions map_of_flight;
  map_of_flight.output = missing;
  CHECK_THAT(error_of(fly(kNowhere, map_of_flight)), says_so);
  MapOptions map_options;
  map_options.output = missing;
  CHECK_THAT(error_of(map(kNowhere, map_options)), says_so);
  GetOptions get_options;
  get_options.output = missing;
  CHECK_THAT(error_of(get(kNowhere, get_options)), says_so);
}
