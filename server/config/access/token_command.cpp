#include "config/access/token_command.h"

#include <charconv>
#include <cstdint>
#include <optional>
#include <random>
#include <utility>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "config/access/signed_token.h"
#include "runtime/log/escape.h"

namespace talus::server {
namespace {

tl::unexpected<Exit> usage_error(std::string_view text, int status) {
  return tl::make_unexpected(Exit{fmt::format("talusd token: {}\n", text), status});
}

std::string random_token_id() {
  std::random_device device;
  return fmt::format("{:08x}{:08x}{:08x}{:08x}", device(), device(), device(), device());
}

}  // namespace

tl::expected<std::chrono::seconds, std::string> parse_validity(std::string_view text) {
  constexpr std::int64_t kDay = 86'400;
  constexpr std::int64_t kTenYears = 3'650 * kDay;
  const char unit = text.empty() ? ' ' : text.back();
  const std::int64_t seconds = unit == 's'   ? 1
                               : unit == 'm' ? 60
                               : unit == 'h' ? 3'600
                               : unit == 'd' ? kDay
                                             : 0;
  std::int64_t count = 0;
  const char* const end = text.data() + text.size() - (text.empty() ? 0 : 1);
  const auto [stop, error] = std::from_chars(text.data(), end, count);
  if (seconds == 0 || error != std::errc{} || stop != end || count < 1 || count > kTenYears / seconds) {
    return tl::make_unexpected(
        fmt::format("\"{}\" is wrong; give 90s, 30m, 12h or 7d, at most 3650d", escaped(text)));
  }
  return std::chrono::seconds{count * seconds};
}

tl::expected<std::string, Exit> token_command(int argc, const char* const* argv,
                                              std::chrono::sys_seconds now) {
  CLI::App app{"Prints a signed token, with which a client may join until the token expires.",
               "talusd token"};
  app.footer(
      "The key is the server's access.signing_key_file. \"head -c 32 /dev/urandom | base64\" makes one.\n"
      "Exit status: 0 success, 1 failure, 2 wrong flags.");
  std::string key_file;
  std::string subject;
  std::string words = "read";
  std::string valid;
  std::string id;
  std::optional<std::string> edit_in;
  std::optional<std::string> edit_not_in;
  app.add_option("--key-file", key_file, "file with the server's signing key")->required()->type_name("FILE");
  app.add_option("--subject", subject, "name of the token's owner, for the server's log")
      ->required()
      ->type_name("NAME");
  app.add_option("--rights", words, "read (required), edit, admin, gateway, separated by commas")
      ->type_name("RIGHTS")
      ->capture_default_str();
  app.add_option("--valid", valid, "time until the token expires: 90s, 30m, 12h, 7d")
      ->required()
      ->type_name("TIME");
  app.add_option("--id", id, "the token's \"jti\", for access.revoked_file; default: 128 random bits")
      ->type_name("ID");
  app.add_option("--edit-in", edit_in,
                 "boxes in which alone its holder may edit, X,Z:X,Z for all heights or X,Y,Z:X,Y,Z, "
                 "separated by semicolons; default: the world")
      ->type_name("BOXES");
  app.add_option("--edit-not-in", edit_not_in, "boxes in which its holder may not edit")->type_name("BOXES");
  if (auto exit = parse_flags(app, argc, argv)) return tl::make_unexpected(*std::move(exit));

  const auto rights = Rights::parse(words);
  if (!rights) return usage_error(fmt::format("--rights: {}", rights.error()), kWrongUse);
  if (!rights->has(Right::read)) return usage_error("--rights: a token needs the right \"read\"", kWrongUse);
  if (rights->has(Right::edit) && on_one_line(subject) != subject) {
    return usage_error(
        "--subject: the right \"edit\" needs a printable subject: UTF-8 without control characters",
        kWrongUse);
  }
  Claims claims{subject, *rights, now, id, now};
  for (const auto& [option, text] :
       {std::pair{"--edit-in", &edit_in}, std::pair{"--edit-not-in", &edit_not_in}}) {
    if (!*text) continue;
    auto boxes = Boxes::parse(**text);
    if (!boxes) return usage_error(fmt::format("{}: {}", option, boxes.error()), kWrongUse);
    if (!rights->has(Right::edit)) {
      return usage_error(fmt::format("{}: has no effect without the right \"edit\"", option), kWrongUse);
    }
    if (text == &edit_in) {
      claims.edit_in = *std::move(boxes);
    } else {
      claims.edit_not_in = *std::move(boxes);
    }
  }
  if (rights->has(Right::gateway) && !rights->has(Right::edit)) {
    return usage_error("--rights: \"gateway\" also needs \"edit\"", kWrongUse);
  }
  const auto validity = parse_validity(valid);
  if (!validity) return usage_error(fmt::format("--valid: {}", validity.error()), kWrongUse);
  const auto key = read_key_file(key_file, kSigningKeyBounds);
  if (!key) return usage_error(key.error(), kFailed);
  claims.expires = now + *validity;
  claims.id = id.empty() ? random_token_id() : id;
  auto token = make_signed_token(key->secret, claims, now);
  if (!token) return usage_error(token.error(), kFailed);
  return *std::move(token);
}

}  // namespace talus::server
