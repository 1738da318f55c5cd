// talusd as a child process.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace talus::e2e {

/// Whether sanitizers watch: their shadow memory is no measure of the server.
#if defined(__SANITIZE_THREAD__) || defined(__SANITIZE_ADDRESS__)
inline constexpr bool kSanitized = true;
#else
inline constexpr bool kSanitized = false;
#endif

/// How tests speak to the server that are not about one way: the same ones run by both
/// (TALUS_E2E_TRANSPORT=websocket).
enum class Transport : std::uint8_t { tcp, websocket };
[[nodiscard]] Transport tested_transport();

/// TALUS_* variables for the child; it gets no others.
using Settings = std::map<std::string, std::string>;

/// A world whose chunk (0, 0, 0) is mixed, and whose heights have valleys within a View.
inline const Settings::value_type kClassicWorld{"TALUS_WORLD", TALUS_SOURCE_DIR "/core/worlds/classic.toml"};

/// How a program that was not expected to go on ended.
struct ProgramResult {
  int status = -1;  // exit status; 128 + n for signal n
  std::string out;
  std::string err;  // of run_program() without lines of progress
};

/// A program running, and what it says.
struct ChildProcess {
  pid_t pid = -1;
  int out = -1;
  int err = -1;
};

/// Runs a program to its end.
[[nodiscard]] ProgramResult run_program(const std::string& path, const std::vector<std::string>& flags,
                                        const Settings& settings = {});
/// Runs talusd to its end.
[[nodiscard]] ProgramResult run_talusd(const std::vector<std::string>& flags, const Settings& settings = {});

/// A server on a free port of 127.0.0.1, unless TALUS_LISTEN is among the settings. If it still runs it ends
/// with its object, and the test fails if it ends with an error: what a sanitizer found does not pass unseen.
class ServerProcess {
 public:
  /// Returns when the server has said where it listens; fails the test if it does not. `meanwhile` is called
  /// as soon as the process runs, before it has said anything.
  explicit ServerProcess(Settings settings = {}, std::vector<std::string> flags = {},
                         const std::function<void(const ServerProcess&)>& meanwhile = {});
  ~ServerProcess();
  ServerProcess(const ServerProcess&) = delete;
  ServerProcess& operator=(const ServerProcess&) = delete;

  /// That RawClients connect to: by WebSocket that of players' HTTP.
  [[nodiscard]] std::uint16_t port() const { return port_; }
  /// Of the operators' HTTP; the server must have been started with --admin.
  [[nodiscard]] std::uint16_t admin_port();
  /// Of players' HTTP; the server must have been started with --http.
  [[nodiscard]] std::uint16_t http_port();
  /// The same by TLS.
  [[nodiscard]] std::uint16_t https_port();
  void signal(int number) const;
  /// SIGSTOP; returns when all its threads stand still, which is later than kill() does.
  void freeze() const;
  /// Waits for the end and returns how it was.
  [[nodiscard]] ProgramResult wait();
  /// What /proc says of each of its threads: the rest of the line that begins with `field`.
  [[nodiscard]] std::vector<std::string> of_threads(std::string_view field) const;
  /// Reads what the server says until a line has `part` in it; the line. Fails the test if none comes.
  std::string await_line(std::string_view part);
  /// Resident memory now.
  [[nodiscard]] std::size_t resident_bytes() const;
  /// The most that it ever was.
  [[nodiscard]] std::size_t max_resident_bytes() const;

  [[nodiscard]] pid_t pid() const { return pid_; }

 private:
  /// From here on there is an object, so whatever fails after this ends the process.
  explicit ServerProcess(const ChildProcess& child) : pid_{child.pid}, out_{child.out}, err_{child.err} {}

  /// Reads what the server says until a line has `before` in it; the number right after it.
  [[nodiscard]] std::uint16_t await_port(std::string_view before);

  pid_t pid_;
  int out_;
  int err_;
  std::string said_;
  std::size_t searched_ = 0;  // of `said_`, by await_line
  std::uint16_t port_ = 0;
};

}  // namespace talus::e2e
