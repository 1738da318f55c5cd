#include "runtime/metrics/process.h"

#include <sys/resource.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

namespace talus::server {
namespace {

/// Fields of /proc/self/stat after the program's name, which may contain blanks and brackets. The first is
/// field 3 of proc(5).
class StatFields {
 public:
  StatFields() {
    std::ifstream file{"/proc/self/stat"};
    const std::string text{std::istreambuf_iterator<char>{file}, {}};
    const std::size_t name_end = text.rfind(')');
    if (name_end == std::string::npos) return;
    std::istringstream rest{text.substr(name_end + 1)};
    fields_.assign(std::istream_iterator<std::string>{rest}, {});
  }

  [[nodiscard]] std::uint64_t number(std::size_t proc_field) const {
    const std::size_t at = proc_field - 3;
    return at < fields_.size() ? std::strtoull(fields_[at].c_str(), nullptr, 10) : 0;
  }

 private:
  std::vector<std::string> fields_;
};

double seconds_of(clockid_t clock) {
  timespec now{};
  ::clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

/// Start time since 1970, computed without /proc/stat, which a hardened unit may hide.
double start_of(const StatFields& stat) {
  constexpr std::size_t kStartTicks = 22;
  const auto ticks_a_second = static_cast<double>(::sysconf(_SC_CLK_TCK));
  const double after_boot = static_cast<double>(stat.number(kStartTicks)) / ticks_a_second;
  return seconds_of(CLOCK_REALTIME) - (seconds_of(CLOCK_BOOTTIME) - after_boot);
}

std::uint64_t open_descriptors() {
  std::error_code failed;
  const std::filesystem::directory_iterator descriptors{"/proc/self/fd", failed};
  if (failed) return 0;
  const auto listed = static_cast<std::uint64_t>(std::distance(begin(descriptors), end(descriptors)));
  return listed - std::min<std::uint64_t>(listed, 1);  // this listing's own descriptor
}

}  // namespace

ProcessStats read_process() {
  constexpr std::size_t kThreads = 20;
  constexpr std::size_t kVirtualBytes = 23;
  constexpr std::size_t kResidentPages = 24;

  ProcessStats stats;
  stats.cpu_seconds = seconds_of(CLOCK_PROCESS_CPUTIME_ID);

  const StatFields stat;
  // Computed once: setting the clock, or the delay between two clock reads, must not change it.
  static const double start = start_of(stat);
  stats.start_seconds = start;
  stats.threads = stat.number(kThreads);
  stats.virtual_bytes = stat.number(kVirtualBytes);
  stats.resident_bytes = stat.number(kResidentPages) * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
  stats.open_descriptors = open_descriptors();
  rlimit files{};
  if (::getrlimit(RLIMIT_NOFILE, &files) == 0) stats.max_descriptors = files.rlim_cur;
  return stats;
}

}  // namespace talus::server
