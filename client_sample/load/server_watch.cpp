#include "server_watch.h"

#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <asio/ip/tcp.hpp>

namespace talus::load {
namespace {

void read_process(int pid, ServerSample& sample) {
  const std::string folder = "/proc/" + std::to_string(pid);
  std::ifstream stat{folder + "/stat"};
  std::string text;
  std::getline(stat, text);
  if (const auto name_end = text.rfind(')'); name_end != std::string::npos) {
    // After the name: state, ten numbers, user and system ticks.
    std::istringstream words{text.substr(name_end + 2)};
    std::string skipped;
    for (int i = 0; i < 11; ++i) words >> skipped;
    double user = 0;
    double system = 0;
    if (words >> user >> system) {
      sample.cpu_seconds = (user + system) / static_cast<double>(::sysconf(_SC_CLK_TCK));
    }
  }
  std::ifstream statm{folder + "/statm"};
  double all_pages = 0;
  double resident_pages = 0;
  if (statm >> all_pages >> resident_pages) {
    sample.resident_bytes = resident_pages * static_cast<double>(::sysconf(_SC_PAGESIZE));
  }
  std::error_code error;
  std::filesystem::directory_iterator files{folder + "/fd", error};
  if (!error) sample.open_files = static_cast<double>(std::distance(begin(files), end(files)));
}

tl::expected<std::string, std::string> fetch(const protocol::Endpoint& from) {
  const std::string where = "http://" + to_string(from) + "/metrics";
  try {
    asio::ip::tcp::iostream stream;
    stream.expires_after(std::chrono::seconds{2});
    stream.connect(from.host, std::to_string(from.port));
    stream << "GET /metrics HTTP/1.1\r\nHost: " << from.host << "\r\nConnection: close\r\n\r\n" << std::flush;
    std::ostringstream answer;
    answer << stream.rdbuf();
    const std::string text = answer.str();
    const auto body = text.find("\r\n\r\n");
    if (text.substr(0, 12) != "HTTP/1.1 200" || body == std::string::npos) {
      return tl::unexpected{"--metrics: " + where +
                            " does not answer with 200; give talusd's --admin address"};
    }
    return text.substr(body + 4);
  } catch (const std::exception& error) {
    return tl::unexpected{"--metrics: " + where + ": " + error.what()};
  }
}

}  // namespace

ServerSample read_metrics(const std::string& text) {
  ServerSample sample;
  std::istringstream lines{text};
  std::string line;
  while (std::getline(lines, line)) {
    if (line.empty() || line.front() == '#') continue;
    // A name, optional labels in braces, a value. Labels may contain spaces.
    const auto name_end = line.find_first_of("{ ");
    const auto labels_end = line.rfind('}');
    const auto value_at = labels_end != std::string::npos ? labels_end + 1 : name_end;
    if (name_end == std::string::npos) continue;
    const std::string name = line.substr(0, name_end);
    std::istringstream number{line.substr(value_at)};
    double value = 0;
    if (!(number >> value)) continue;
    if (name == "process_cpu_seconds_total") sample.cpu_seconds = value;
    if (name == "process_resident_memory_bytes") sample.resident_bytes = value;
    if (name == "process_open_fds") sample.open_files = value;
    if (name.substr(0, 6) == "talus_" && name.find("_bucket") == std::string::npos)
      sample.counters[name] += value;
  }
  return sample;
}

tl::expected<ServerSample, std::string> ServerWatch::sample() const {
  ServerSample sample;
  if (metrics_) {
    const auto text = fetch(*metrics_);
    if (!text) return tl::unexpected{text.error()};
    sample = read_metrics(*text);
  }
  if (pid_ == 0) return sample;
  ServerSample process;
  read_process(pid_, process);
  if (!process.cpu_seconds) {
    return tl::unexpected{"--server-pid " + std::to_string(pid_) +
                          ": there is no such process, or it cannot be read"};
  }
  if (!sample.cpu_seconds) sample.cpu_seconds = process.cpu_seconds;
  if (!sample.resident_bytes) sample.resident_bytes = process.resident_bytes;
  if (!sample.open_files) sample.open_files = process.open_files;
  return sample;
}

}  // namespace talus::load
