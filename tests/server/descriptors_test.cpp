// The limit of open files. What changes the process runs in a child process.
#include "net/descriptors.h"

#include <sys/resource.h>

#include <catch2/catch.hpp>

#include "in_child.h"

using namespace talus::server;

TEST_CASE("the limit of open files becomes what is needed, from above and from below") {
  const int wrong = in_child([] {
    rlimit limit{};
    if (::getrlimit(RLIMIT_NOFILE, &limit) != 0) return 1;
    const rlim_t most = limit.rlim_max;
    for (const rlim_t before : {rlim_t{64}, most}) {
      limit.rlim_cur = before;
      if (::setrlimit(RLIMIT_NOFILE, &limit) != 0) return 2;
      if (set_descriptor_limit(200) != 200) return 3;
      if (::getrlimit(RLIMIT_NOFILE, &limit) != 0 || limit.rlim_cur != 200 || limit.rlim_max != most)
        return 4;
    }
    limit = {100, 150};
    if (::setrlimit(RLIMIT_NOFILE, &limit) != 0) return 5;
    return set_descriptor_limit(200) == 150 ? 0 : 6;
  });
  CHECK(wrong == 0);
}

TEST_CASE("the limit of open files is raised to what is needed, and not lowered under open descriptors") {
  const int wrong = in_child([] {
    rlimit limit{100, 300};
    if (::setrlimit(RLIMIT_NOFILE, &limit) != 0) return 1;
    if (raise_descriptor_limit(200) != 200 || raise_descriptor_limit(50) != 200) return 2;
    if (::getrlimit(RLIMIT_NOFILE, &limit) != 0 || limit.rlim_cur != 200) return 3;
    return raise_descriptor_limit(400) == 300 ? 0 : 4;
  });
  CHECK(wrong == 0);
}

TEST_CASE("a server needs a descriptor for each connection, and few besides") {
  CHECK(descriptors_needed(2048, 2) == 2048 + 112 + 6);
  CHECK(descriptors_needed(1, 1024) == 1 + 112 + 3 * 1024);
}

TEST_CASE("the highest descriptors that the limit allows are spare") {
  const int wrong = in_child([] {
    const rlimit limit{100, 100};
    if (::setrlimit(RLIMIT_NOFILE, &limit) != 0) return 1;
    const int first = 100 - static_cast<int>(kSpareDescriptors);
    return is_spare(first) && is_spare(99) && !is_spare(first - 1) && !is_spare(0) ? 0 : 2;
  });
  CHECK(wrong == 0);
}
