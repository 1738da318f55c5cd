// Key files, rights, reloads, and the command that makes tokens.
#include "config/access/access_control.h"

#include <sys/stat.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "config/access/token_command.h"
#include "scratch_directory.h"
#include "signed_tokens.h"

using namespace talus::server;
using namespace std::chrono_literals;

namespace {

const std::string kSecretText = "correct horse battery staple";

/// Key files with both kinds of keys.
struct Files {
  ScratchDirectory scratch;
  Access settings{scratch.write("secret", kSecretText + "\n"), "read,edit",
                  scratch.write("key", kKeyText + "\n"), "auto"};
};

AccessControl control_of(const Access& settings) {
  auto keys = load_keys(settings);
  REQUIRE(keys.has_value());
  return {settings, *std::move(keys)};
}

std::string load_error(const Access& settings) {
  const auto keys = load_keys(settings);
  REQUIRE_FALSE(keys.has_value());
  CHECK(keys.error().find('\n') == std::string::npos);
  return keys.error();
}

AuthError denied(const tl::expected<Grant, AuthError>& answer) {
  REQUIRE_FALSE(answer.has_value());
  return answer.error();
}

tl::expected<std::string, Exit> command(std::vector<const char*> words) {
  words.insert(words.begin(), "token");
  return token_command(static_cast<int>(words.size()), words.data(), kNow);
}

}  // namespace

TEST_CASE("without keys every client may read, whatever token it sends") {
  const AccessControl access = control_of({});
  for (const char* shown : {"", "anything"}) {
    const auto grant = access.admit(shown, kNow);
    REQUIRE(grant.has_value());
    CHECK(grant->rights == Rights{Right::read});
  }
}

TEST_CASE("with a key a client without a token is refused, unless the configuration gives it rights") {
  Files files;
  CHECK(denied(control_of(files.settings).admit("", kNow)).failure == AuthFailure::missing);
  files.settings.without_token = "read";
  const AccessControl access = control_of(files.settings);
  CHECK(access.admit("", kNow)->rights == Rights{Right::read});
  CHECK(denied(access.admit("wrong", kNow)).failure == AuthFailure::not_accepted);
}

TEST_CASE("the shared secret gives the rights that the configuration says, and nothing near it does") {
  const Files files;
  const AccessControl access = control_of(files.settings);
  const auto grant = access.admit(kSecretText, kNow);
  REQUIRE(grant.has_value());
  CHECK(grant->rights == Rights{Right::read, Right::edit});
  CHECK_FALSE(grant->expires.has_value());
  for (const std::string& near : {kSecretText + "\n", kSecretText + " ", kSecretText.substr(1),
                                  kSecretText.substr(0, kSecretText.size() - 1), std::string{"x"}}) {
    CAPTURE(near);
    CHECK(denied(access.admit(near, kNow)).failure == AuthFailure::not_accepted);
  }
}

TEST_CASE("a signed token gives its own rights, its subject and its expiry") {
  const Files files;
  const auto grant =
      control_of(files.settings).admit(token({"alice", {Right::read, Right::admin}, kNow + 1h}), kNow);
  REQUIRE(grant.has_value());
  CHECK(grant->rights == Rights{Right::read, Right::admin});
  CHECK(grant->subject == "alice");
  CHECK(grant->expires == kNow + 1h);
}

TEST_CASE("an error about a key file is one line that names the setting and the file") {
  const ScratchDirectory scratch;
  const auto secret = [&](const std::string& file) { return load_error({file, "read", {}, "auto"}); };
  const std::string brief = scratch.write("brief", "only 15 bytes..\n");
  CHECK_THAT(secret(brief),
             Catch::StartsWith("access.secret_file " + brief + ": has 15 bytes; it must have 16 to 1024"));
  CHECK_THAT(secret(scratch.write("long", std::string(1025, 'x'))), Catch::Contains("has 1025 bytes"));
  CHECK_THAT(secret(scratch.write("huge", std::string(100'000, 'x'))), Catch::Contains("over 8192"));
  CHECK_THAT(secret("/nowhere"), Catch::Contains("No such file"));
  CHECK_THAT(secret(scratch.path().string()), Catch::Contains("not a regular file"));
  const std::string pipe = (scratch.path() / "pipe").string();
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  CHECK_THAT(secret(pipe), Catch::Contains("not a regular file"));
  const std::string key = scratch.write("key", std::string(31, 'k'));
  CHECK_THAT(load_error({{}, "read", key, "auto"}),
             Catch::StartsWith("access.signing_key_file " + key + ": has 31 bytes; it must have 32 to 4096"));
}

TEST_CASE("a key file without a secret in it is refused in one line") {
  const ScratchDirectory scratch;
  for (const std::string& text : {std::string(64, '\0'), std::string(40, '\n'), std::string(64, 'k'),
                                  std::string(20, ' ') + "\t\r\n" + std::string(20, '\0')}) {
    const std::string file = scratch.write("plain", text);
    const std::string said = file + ": has no secret: it is blank, or one character again and again";
    CHECK_THAT(load_error({file, "read", {}, "auto"}), Catch::StartsWith("access.secret_file " + said));
    CHECK_THAT(load_error({{}, "read", file, "auto"}), Catch::StartsWith("access.signing_key_file " + said));
  }
  // Passwords that others gave are theirs to judge.
  CHECK(read_key_file(scratch.write("short", "x"), {1, 16}).has_value());
}

TEST_CASE("a single trailing newline is ignored, and more, or a byte order mark, are refused") {
  const ScratchDirectory scratch;
  const std::string text = "16 secret bytes.";
  for (const std::string end : {"", "\n", "\r\n"}) {
    CHECK(read_key_file(scratch.write("file", text + end), {16, 16})->secret.bytes() == text);
  }
  for (const std::string end : {"\n\n", "\r\n\r\n", "\r\n\n", "\r\r\n"}) {
    CHECK_THAT(read_key_file(scratch.write("file", text + end), {1, 24}).error(),
               Catch::Contains("file: has empty lines at its end; end it after the secret"));
  }
  CHECK_THAT(read_key_file(scratch.write("file", "\xEF\xBB\xBF" + text), {1, 20}).error(),
             Catch::Contains("file: begins with a byte order mark; save it as UTF-8 without one"));
}

TEST_CASE("a binary key has all bytes of its file, newlines too") {
  const ScratchDirectory scratch;
  const KeyBounds bounds{32, 32, "random bytes", true};
  for (const std::string& text :
       {"\xEF\xBB\xBF" + std::string(27, 'k') + "\n\n", std::string(31, 'k') + '\0'}) {
    CHECK(read_key_file(scratch.write("file", text), bounds)->secret.bytes() == text);
  }
  CHECK_THAT(read_key_file(scratch.write("file", std::string(32, 'k') + "x\n"), bounds).error(),
             Catch::Contains("has 34 bytes; it must have 32, as random bytes"));
}

TEST_CASE("a key file that other users may read or change is a warning") {
  const Files files;
  for (const mode_t mode : {0600U, 0400U, 0640U, 0440U}) {
    REQUIRE(::chmod(files.settings.secret_file.c_str(), mode) == 0);
    REQUIRE(::chmod(files.settings.signing_key_file.c_str(), mode) == 0);
    CHECK(load_keys(files.settings)->warnings.empty());
  }
  for (const mode_t mode : {0644U, 0604U, 0602U, 0660U}) {
    REQUIRE(::chmod(files.settings.secret_file.c_str(), mode) == 0);
    CAPTURE(mode);
    const auto keys = load_keys(files.settings);
    REQUIRE(keys->warnings.size() == 1);
    CHECK_THAT(keys->warnings[0], Catch::StartsWith("access.secret_file ") && Catch::Contains("chmod"));
  }
}

TEST_CASE("a configuration that rejects every client is refused") {
  CHECK_THAT(load_error({{}, "read", {}, "none"}), Catch::StartsWith("access.without_token"));
}

TEST_CASE("a reload takes the new keys, and keeps all old keys if one file is bad") {
  Files files;
  AccessControl access = control_of(files.settings);
  const std::string fresh = "a secret for tomorrow";
  files.scratch.write("secret", fresh);
  CHECK(access.admit(kSecretText, kNow).has_value());
  REQUIRE(access.reload(files.settings).has_value());
  CHECK_FALSE(access.admit(kSecretText, kNow).has_value());
  CHECK(access.admit(fresh, kNow).has_value());

  files.scratch.write("secret", "the secret after tomorrow");
  files.scratch.write("key", "short");
  const auto failed = access.reload(files.settings);
  REQUIRE_FALSE(failed.has_value());
  CHECK_THAT(failed.error(), Catch::Contains("access.signing_key_file") && Catch::Contains("old keys stay"));
  CHECK(access.admit(fresh, kNow).has_value());
  CHECK(access.admit(token({"a", {Right::read}, kNow + 1h}), kNow).has_value());
  CHECK_FALSE(access.admit("", kNow).has_value());
}

TEST_CASE("a reload that cannot read a key revokes and blocks all the same") {
  Files files;
  files.settings.revoked_file = files.scratch.write("revoked", "");
  files.settings.blocked_file = files.scratch.write("blocked", "");
  AccessControl access = control_of(files.settings);
  const std::string mallorys = token({"mallory", {Right::read}, kNow + 1h, "m1"});
  const std::string trudys = token({"trudy", {Right::read}, kNow + 1h});
  CHECK(access.admit(mallorys, kNow).has_value());
  files.scratch.write("key", "short");
  files.scratch.write("revoked", "jti m1\n");
  files.scratch.write("blocked", "subject trudy\n");
  CHECK_FALSE(access.reload(files.settings).has_value());
  CHECK(denied(access.admit(mallorys, kNow)).failure == AuthFailure::revoked);
  CHECK(denied(access.admit(trudys, kNow)).failure == AuthFailure::blocked);

  // And one bad list keeps neither the other list nor the keys back.
  files.scratch.write("key", kKeyText);
  files.scratch.write("revoked", "rubbish\n");
  files.scratch.write("blocked", "");
  const auto failed = access.reload(files.settings);
  REQUIRE_FALSE(failed.has_value());
  CHECK_THAT(failed.error(), Catch::Contains("revoked: line 1") && Catch::Contains("old list stays"));
  CHECK(denied(access.admit(mallorys, kNow)).failure == AuthFailure::revoked);
  CHECK(access.admit(trudys, kNow).has_value());
}

TEST_CASE("tokens of the current and of the previous signing key are accepted, of a third are not") {
  Files files;
  const std::string before = "fedcba9876543210fedcba9876543210";
  files.settings.previous_signing_key_file = files.scratch.write("key.before", before);
  AccessControl access = control_of(files.settings);
  const Claims claims{"a", {Right::read}, kNow + 1h};
  CHECK(access.admit(token(claims), kNow).has_value());
  CHECK(access.admit(token(claims, before), kNow).has_value());
  CHECK(denied(access.admit(token(claims, std::string(32, 'x')), kNow)).failure == AuthFailure::not_accepted);
  CHECK(denied(access.admit(token(claims, before), kNow + 2h)).failure == AuthFailure::expired);
  CHECK(denied(access.admit(token(claims), kNow + 2h)).failure == AuthFailure::expired);

  files.scratch.write("key.before", kKeyText);
  REQUIRE(access.reload(files.settings).has_value());
  CHECK_FALSE(access.admit(token(claims, before), kNow).has_value());
  CHECK(access.admit(token(claims), kNow).has_value());
}

TEST_CASE("rights are read back from their text, and read is among them") {
  for (const char* text : {"none", "read", "read,edit", "read,admin", "read,edit,admin", "read,edit,gateway",
                           "read,edit,admin,gateway"}) {
    CHECK(to_string(*Rights::parse(text)) == text);
  }
  CHECK(Rights::parse("edit,read") == Rights{Right::read, Right::edit});
  CHECK(Rights::parse(" read, edit ") == Rights{Right::read, Right::edit});
  for (const char* text : {"", ",", "read,", ",read", "edit", "Read", "read edit", "none,read", "root"}) {
    CAPTURE(text);
    CHECK_FALSE(Rights::parse(text).has_value());
  }
}

TEST_CASE("talusd token makes tokens that the server accepts") {
  const Files files;
  const std::string key = files.settings.signing_key_file.string();
  const auto made = command({"--key-file", key.c_str(), "--subject", "Zo\xc3\xab \"the\" editor", "--rights",
                             "edit,read", "--valid", "12h"});
  REQUIRE(made.has_value());
  const auto claims = read(*made);
  REQUIRE(claims.has_value());
  CHECK(claims->subject == "Zo\xc3\xab \"the\" editor");
  CHECK(claims->rights == Rights{Right::read, Right::edit});
  CHECK(claims->expires == kNow + 12h);
}

TEST_CASE("talusd token refuses an unprintable subject for an editor") {
  const Files files;
  const std::string key = files.settings.signing_key_file.string();
  for (const char* subject : {"a\nb", "\x1b[2J", "\xff"}) {
    const auto refused =
        command({"--key-file", key.c_str(), "--subject", subject, "--rights", "read,edit", "--valid", "1h"});
    REQUIRE_FALSE(refused.has_value());
    CHECK_THAT(refused.error().text, Catch::Contains("--subject"));
  }
}

TEST_CASE("talusd token limits the boxes in which its holder may edit, and the server reads them") {
  const Files files;
  const std::string key = files.settings.signing_key_file.string();
  const auto made = command({"--key-file", key.c_str(), "--subject", "a", "--rights", "read,edit", "--valid",
                             "1h", "--edit-in", "31,31:0,0; 100,0,0:131,9,31", "--edit-not-in", "8,8:9,9"});
  REQUIRE(made.has_value());
  const auto grant = control_of(files.settings).admit(*made, kNow);
  REQUIRE(grant.has_value());
  REQUIRE(grant->edit_in.has_value());
  CHECK(grant->edit_in->text() == "0,0:31,31; 100,0,0:131,9,31");
  CHECK(grant->edit_not_in.text() == "8,8:9,9");
  const auto nowhere = command({"--key-file", key.c_str(), "--subject", "a", "--rights", "read,edit",
                                "--valid", "1h", "--edit-in", ""});
  CHECK(read(*nowhere)->edit_in == Boxes{});
  CHECK_FALSE(read(token({"a", {Right::read, Right::edit}, kNow + 1h}))->edit_in.has_value());
}

TEST_CASE("talusd token refuses bounds that are wrong or bound nothing") {
  const Files files;
  const std::string key = files.settings.signing_key_file.string();
  const auto wrong = [&](const char* rights, const char* option, const char* boxes) {
    const auto made = command(
        {"--key-file", key.c_str(), "--subject", "a", "--rights", rights, "--valid", "1h", option, boxes});
    REQUIRE_FALSE(made.has_value());
    CHECK(made.error().status == 2);
    CHECK(std::count(made.error().text.begin(), made.error().text.end(), '\n') == 1);
    return made.error().text;
  };
  CHECK_THAT(wrong("read,edit", "--edit-in", "1,2"),
             Catch::StartsWith("talusd token: --edit-in: \"1,2\" is not a box"));
  CHECK_THAT(wrong("read,edit", "--edit-not-in", "x"), Catch::StartsWith("talusd token: --edit-not-in: "));
  CHECK_THAT(wrong("read", "--edit-in", "1,2:3,4"), Catch::Contains("without the right \"edit\""));
  CHECK_THAT(wrong("read,gateway", "--edit-in", ""),
             Catch::Contains("needs \"edit\"") || Catch::Contains("without the right \"edit\""));
}

TEST_CASE("talusd token says in one line what is wrong") {
  const Files files;
  const std::string key = files.settings.signing_key_file.string();
  const std::string brief = files.settings.secret_file.string();
  const std::string endless(8000, 'n');
  const auto wrong = [&](const char* file, const char* subject, const char* rights, const char* valid) {
    const auto made =
        command({"--key-file", file, "--subject", subject, "--rights", rights, "--valid", valid});
    REQUIRE_FALSE(made.has_value());
    CHECK(std::count(made.error().text.begin(), made.error().text.end(), '\n') == 1);
    CHECK_THAT(made.error().text, Catch::StartsWith("talusd token: "));
    return made.error().status;
  };
  CHECK(wrong(key.c_str(), "a", "write", "12h") == 2);
  CHECK(wrong(key.c_str(), "a", "none", "12h") == 2);
  for (const char* valid :
       {"", "12", "h", "0h", "-1h", "1.5h", "3651d", "9223372036854775807d", "12 h", "1w"}) {
    CAPTURE(valid);
    CHECK(wrong(key.c_str(), "a", "read", valid) == 2);
  }
  CHECK(wrong("/nowhere", "a", "read", "12h") == 1);
  CHECK(wrong(brief.c_str(), "a", "read", "12h") == 1);
  CHECK(wrong(key.c_str(), "\xff\xfe", "read", "12h") == 1);
  CHECK(wrong(key.c_str(), endless.c_str(), "read", "12h") == 1);
  CHECK(command({}).error().status == 2);
  CHECK(command({"--help"}).error().status == 0);
}
