#include "server_process.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>
#include <algorithm>

#include <array>
#include <catch2/catch.hpp>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <utility>

#include "progress_lines.h"

namespace talus::e2e {
namespace {

constexpr int kPatienceMs = 60'000;  // sanitizers are slow; a server that works is not waited for
constexpr int kTimeToEndMs = 1000;

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> all;
  for (std::string& text : texts) all.push_back(text.data());
  all.push_back(nullptr);
  return all;
}

std::vector<std::string> environment_of(const Settings& settings) {
  std::vector<std::string> variables;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    if (std::string_view{*entry}.substr(0, 6) != "TALUS_") variables.emplace_back(*entry);
  }
  for (const auto& [name, value] : settings) variables.push_back(name + "=" + value);
  return variables;
}

ChildProcess start(const std::string& path, const std::vector<std::string>& flags, const Settings& settings) {
  std::vector<std::string> arguments{path};
  arguments.insert(arguments.end(), flags.begin(), flags.end());
  std::vector<std::string> variables = environment_of(settings);

  std::array<int, 2> out{};
  std::array<int, 2> err{};
  REQUIRE(::pipe2(out.data(), O_CLOEXEC) == 0);
  REQUIRE(::pipe2(err.data(), O_CLOEXEC) == 0);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, out[1], STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, err[1], STDERR_FILENO);
  pid_t pid = -1;
  const int failed = ::posix_spawn(&pid, path.c_str(), &actions, nullptr, pointers(arguments).data(),
                                   pointers(variables).data());
  posix_spawn_file_actions_destroy(&actions);
  ::close(out[1]);
  ::close(err[1]);
  REQUIRE(failed == 0);
  return {pid, out[0], err[0]};
}

/// Appends what one read gives; false at the end of the stream.
bool read_some(int fd, std::string& text) {
  std::array<char, 4096> buffer{};
  const ssize_t bytes = ::read(fd, buffer.data(), buffer.size());
  if (bytes > 0) text.append(buffer.data(), static_cast<std::size_t>(bytes));
  return bytes > 0;
}

/// Reads both streams to their ends, whichever has something, so that neither pipe fills up; false where
/// nothing came for so long.
bool read_to_end(int out, int err, ProgramResult& ended, int patience_ms = kPatienceMs) {
  std::array<pollfd, 2> streams{{{out, POLLIN, 0}, {err, POLLIN, 0}}};
  while (streams[0].fd >= 0 || streams[1].fd >= 0) {
    if (::poll(streams.data(), streams.size(), patience_ms) <= 0) return false;
    if (streams[0].revents != 0 && !read_some(out, ended.out)) streams[0].fd = -1;
    if (streams[1].revents != 0 && !read_some(err, ended.err)) streams[1].fd = -1;
  }
  return true;
}

/// No test's client is late on a busy machine, unless the test is about that. Variables override a test's
/// --config file, so such a server has its own.
const Settings kPatience{{"TALUS_LIMITS_HANDSHAKE_TIMEOUT_MS", "3600000"},
                         {"TALUS_LIMITS_IDLE_TIMEOUT_MS", "3600000"},
                         {"TALUS_LIMITS_WRITE_TIMEOUT_MS", "3600000"}};

ChildProcess start_server(Settings settings, std::vector<std::string> flags) {
  settings.emplace("TALUS_THREADS_IO", "2");  // so that connections are dealt, also on a small machine
  const bool says_config = std::find(flags.begin(), flags.end(), "--config") != flags.end();
  if (!says_config) settings.insert(kPatience.begin(), kPatience.end());
  const bool says_world = says_config || std::find(flags.begin(), flags.end(), "--world") != flags.end();
  if (kSanitized && !says_world) settings.insert(kClassicWorld);  // served_world.h
  if (!settings.contains("TALUS_LISTEN")) flags.insert(flags.end(), {"--listen", "127.0.0.1:0"});
  const bool says_http = std::find(flags.begin(), flags.end(), "--http") != flags.end();
  if (tested_transport() == Transport::websocket && !says_http) {
    flags.insert(flags.end(), {"--http", "127.0.0.1:0"});
  }
  return start(TALUSD_PATH, flags, settings);
}

int reap(pid_t pid) {
  int status = 0;
  ::waitpid(pid, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace

Transport tested_transport() {
  const char* const wanted = std::getenv("TALUS_E2E_TRANSPORT");
  return wanted != nullptr && std::string_view{wanted} == "websocket" ? Transport::websocket : Transport::tcp;
}

ProgramResult run_program(const std::string& path, const std::vector<std::string>& flags,
                          const Settings& settings) {
  const ChildProcess child = start(path, flags, settings);
  ProgramResult ended;
  (void)read_to_end(child.out, child.err, ended);
  ended.status = reap(child.pid);
  ended.err = talus::test::without_progress(ended.err);
  ::close(child.out);
  ::close(child.err);
  return ended;
}

ProgramResult run_talusd(const std::vector<std::string>& flags, const Settings& settings) {
  return run_program(TALUSD_PATH, flags, settings);
}

ServerProcess::ServerProcess(Settings settings, std::vector<std::string> flags,
                             const std::function<void(const ServerProcess&)>& meanwhile)
    : ServerProcess{start_server(std::move(settings), std::move(flags))} {
  if (meanwhile) meanwhile(*this);
  port_ = await_port("listening on 127.0.0.1:");
  if (tested_transport() == Transport::websocket) port_ = http_port();
}

ServerProcess::~ServerProcess() {
  if (pid_ > 0) {
    // A second signal ends it at once, whoever is still connected; it may also meet it on its way out.
    ProgramResult ended;
    const auto patience_ends = std::chrono::steady_clock::now() + std::chrono::milliseconds{kPatienceMs};
    bool over = false;
    while (!over && std::chrono::steady_clock::now() < patience_ends) {
      signal(SIGTERM);
      over = read_to_end(out_, err_, ended, kTimeToEndMs);
    }
    if (!over) signal(SIGKILL);
    ended.status = reap(pid_);
    if (ended.status != 0 && ended.status != 128 + SIGTERM) {
      FAIL_CHECK("talusd ended with " << ended.status << ":\n" << said_ << ended.out << ended.err);
    }
  }
  ::close(out_);
  ::close(err_);
}

std::uint16_t ServerProcess::await_port(std::string_view before) {
  for (;;) {
    const std::size_t at = said_.find(before);
    if (at != std::string::npos && said_.find('\n', at) != std::string::npos) {
      return static_cast<std::uint16_t>(std::stoi(said_.substr(at + before.size())));
    }
    pollfd stream{out_, POLLIN, 0};
    const bool more = ::poll(&stream, 1, kPatienceMs) > 0 && read_some(out_, said_);
    INFO(said_);
    REQUIRE(more);
  }
}

std::uint16_t ServerProcess::admin_port() {
  return await_port("metrics and health on http://127.0.0.1:");
}

std::uint16_t ServerProcess::http_port() {
  return await_port("HTTP and WebSocket on http://127.0.0.1:");
}

std::uint16_t ServerProcess::https_port() {
  return await_port("HTTP and WebSocket on https://127.0.0.1:");
}

std::string ServerProcess::await_line(std::string_view part) {
  for (;;) {
    for (std::size_t end = said_.find('\n', searched_); end != std::string::npos;
         end = said_.find('\n', searched_)) {
      const std::string line = said_.substr(searched_, end - searched_);
      searched_ = end + 1;
      if (line.find(part) != std::string::npos) return line;
    }
    pollfd stream{out_, POLLIN, 0};
    const bool more = ::poll(&stream, 1, kPatienceMs) > 0 && read_some(out_, said_);
    INFO(said_);
    REQUIRE(more);
  }
}

void ServerProcess::signal(int number) const {
  ::kill(pid_, number);
}

void ServerProcess::freeze() const {
  signal(SIGSTOP);
  ::waitpid(pid_, nullptr, WUNTRACED);
}

ProgramResult ServerProcess::wait() {
  ProgramResult ended;
  ended.out = said_;
  (void)read_to_end(out_, err_, ended);
  ended.status = reap(std::exchange(pid_, -1));
  return ended;
}

std::vector<std::string> ServerProcess::of_threads(std::string_view field) const {
  std::vector<std::string> found;
  for (const auto& thread : std::filesystem::directory_iterator{"/proc/" + std::to_string(pid_) + "/task"}) {
    std::ifstream in{thread.path() / "status"};
    for (std::string line; std::getline(in, line);) {
      if (line.starts_with(field)) found.push_back(line.substr(field.size()));
    }
  }
  return found;
}

std::size_t ServerProcess::resident_bytes() const {
  std::ifstream in{"/proc/" + std::to_string(pid_) + "/statm"};
  std::size_t size_pages = 0;
  std::size_t resident_pages = 0;
  in >> size_pages >> resident_pages;
  return resident_pages * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

std::size_t ServerProcess::max_resident_bytes() const {
  constexpr std::string_view kField{"VmHWM:"};
  std::ifstream in{"/proc/" + std::to_string(pid_) + "/status"};
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with(kField)) return std::stoull(line.substr(kField.size())) * 1024;
  }
  FAIL("the system reports no VmHWM");
  return 0;
}

}  // namespace talus::e2e
