// Giving up what root may do. What changes the process is done in a child of it.
#include "privileges/privileges.h"

#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>

#include "net/descriptors.h"
#include "scratch_directory.h"
#include "store/data_directory.h"

using namespace talus::server;

namespace {

/// What `act` returns, as a child process does it.
template <typename Act>
int in_child(Act&& act) {
  const pid_t child = ::fork();
  if (child == 0) ::_exit(act());
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

bool root_is_needed() {
  if (::geteuid() == 0) return false;
  WARN("only root can give up what root may do: not tested");
  return true;
}

std::string account_error(const std::string& text) {
  const auto account = find_account(text);
  REQUIRE_FALSE(account.has_value());
  CHECK(account.error().find('\n') == std::string::npos);
  CHECK_THAT(account.error(), Catch::StartsWith("user: \"") && Catch::Contains("UID:GID"));
  return account.error();
}

}  // namespace

TEST_CASE("a user is found by name, by number, and by numbers that no name has") {
  const auto nobody = find_account("nobody");
  REQUIRE(nobody.has_value());
  CHECK(nobody->uid != 0);
  CHECK(find_account(std::to_string(nobody->uid))->gid == nobody->gid);
  const auto numbers = find_account("4780:4781");
  REQUIRE(numbers.has_value());
  CHECK(numbers->uid == 4780);
  CHECK(numbers->gid == 4781);
  CHECK(numbers->groups.empty());
}

TEST_CASE("root in any spelling, and who is nobody, is refused") {
  for (const char* text : {"root", "0", "0:0", "0:4780"})
    CHECK_THAT(account_error(text), Catch::Contains("root"));
  CHECK_THAT(account_error("4780:0"), Catch::Contains("root's group"));
  for (const char* text : {"no-such-user", "", ":", "4780:", "4780:x", "-1:5", "4294967295:5", "5:4294967295",
                           "99999999999:5", "nobody:nogroup", "\x1b[2J"}) {
    CAPTURE(text);
    CHECK(account_error(text).find('\x1b') == std::string::npos);
  }
}

TEST_CASE("who became another has his user and groups alone, and no way back") {
  if (root_is_needed()) return;
  const int wrong = in_child([] {
    if (!become({"4780:4781", 4780, 4781, {4782}})) return 1;
    uid_t real = 0, effective = 0, saved = 0;
    if (::getresuid(&real, &effective, &saved) != 0 || real != 4780 || effective != 4780 || saved != 4780)
      return 2;
    gid_t groups[8] = {};
    if (::getgroups(8, groups) != 1 || groups[0] != 4782) return 3;
    if (::setuid(0) == 0 || ::seteuid(0) == 0 || ::setresuid(0, 0, 0) == 0 || ::setgid(0) == 0) return 4;
    if (::access("/etc/shadow", R_OK) == 0) return 5;
    return become({"4780:4781", 4780, 4781, {4782}}) ? 0 : 6;  // he is it already
  });
  CHECK(wrong == 0);
}

TEST_CASE("who is not root cannot become another") {
  if (root_is_needed()) return;
  const int wrong = in_child([] {
    if (::setuid(4780) != 0) return 1;
    const auto done = become({"4790:4790", 4790, 4790, {}});
    return !done && done.error().find("only root can become 4790:4790") != std::string::npos ? 0 : 2;
  });
  CHECK(wrong == 0);
}

TEST_CASE("new privileges are renounced and the memory is hidden") {
  const int wrong = in_child([] {
    if (!renounce_new_privileges() || ::prctl(PR_GET_NO_NEW_PRIVS, 0, 0, 0, 0) != 1) return 1;
    hide_memory();
    return ::prctl(PR_GET_DUMPABLE, 0, 0, 0, 0) == 0 ? 0 : 2;
  });
  CHECK(wrong == 0);
}

TEST_CASE("a directory made for another user is his, and one that is there stays whose it is") {
  if (root_is_needed()) return;
  const ScratchDirectory scratch;
  const auto owner_of = [](const std::filesystem::path& path) {
    struct stat about {};
    REQUIRE(::stat(path.c_str(), &about) == 0);
    return about.st_uid;
  };
  REQUIRE(DataDirectory::make_for(scratch / "a/b/", 4780, 4780).has_value());
  CHECK(owner_of(scratch / "a") == 0);
  CHECK(owner_of(scratch / "a/b") == 4780);
  REQUIRE(DataDirectory::make_for(scratch / "a", 4780, 4780).has_value());
  CHECK(owner_of(scratch / "a") == 0);
}

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

TEST_CASE("a server needs a descriptor for each connection, and few besides") {
  CHECK(descriptors_needed(2048, 2) == 2048 + 128 + 6);
  CHECK(descriptors_needed(1, 1024) == 1 + 128 + 3 * 1024);
}
