#include "program.h"

#include <cerrno>
#include <cstring>
#include <exception>
#include <iostream>

#include <asio/co_spawn.hpp>
#include <asio/io_context.hpp>

#include "command_line.h"

namespace talus::cli {
namespace {

int failed(const std::string& line, int status = 1) {
  std::cerr << "talus-client: " << line << '\n';
  return status;
}

asio::awaitable<CommandResult> start(const CommandLine& line) {
  if (const auto* options = std::get_if<GetOptions>(&line.options)) return get(line.target, *options);
  if (const auto* options = std::get_if<AtOptions>(&line.options)) return at(line.target, *options);
  if (const auto* options = std::get_if<FlyOptions>(&line.options)) return fly(line.target, *options);
  if (const auto* options = std::get_if<EditOptions>(&line.options)) return edit(line.target, *options);
  return map(line.target, std::get<MapOptions>(line.options));
}

CommandResult run(const CommandLine& line) {
  asio::io_context io{1};
  CommandResult result;
  std::exception_ptr thrown;
  asio::co_spawn(io, start(line), [&](const std::exception_ptr& exception, CommandResult ended) {
    thrown = exception;
    result = std::move(ended);
  });
  io.run();
  if (thrown) std::rethrow_exception(thrown);
  return result;
}

// Flushes output, which could otherwise be lost in a buffer.
CommandResult finish_printing() {
  errno = 0;
  if (std::cout.flush()) return {};
  return tl::unexpected{std::string{"standard output: cannot be written"} +
                        (errno == 0 ? "" : std::string{": "} + std::strerror(errno))};
}

}  // namespace

int run_program(int argc, const char* const* argv, const std::string& version) try {
  const auto line = read_command_line(argc, argv, version);
  if (!line && line.error().status != 0) return failed(line.error().text, line.error().status);
  CommandResult result;
  if (line) {
    result = run(*line);
  } else {
    std::cout << line.error().text;
  }
  if (result) result = finish_printing();
  return result ? 0 : failed(result.error());
} catch (const std::exception& error) {  // the system refuses memory, a thread or a descriptor
  return failed(std::string{"cannot go on: "} + error.what());
}

}  // namespace talus::cli
