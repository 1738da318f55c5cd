#include "commands/cluster/check.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <optional>
#include <string_view>
#include <thread>

#include <fmt/format.h>

#include <talus/progress/progress_bar.h>

#include "cluster/jetstream/stream_admin.h"
#include "cluster/jetstream/stream_settings.h"
#include "commands/cluster/connection_words.h"
#include "commands/cluster/formats_line.h"
#include "commands/cluster/nats_greeting.h"
#include "commands/cluster/replica_comparison.h"
#include "commands/cluster/stream_contents.h"
#include "commands/cluster/stream_world.h"
#include "runtime/log/utc_time.h"

namespace talus::server::cluster_tool {
namespace {

using namespace std::chrono_literals;
using Kind = Finding::Kind;

constexpr auto kPatience = 500ms;
constexpr auto kDenialIn = 300ms;
constexpr int kNoMessage = 404;
constexpr std::array<std::string_view, 2> kSchemes{"nats", "tls"};

class Checker {
 public:
  Checker(const Target& target, const cluster::Genesis& genesis, std::uint64_t messages)
      : target_{target}, genesis_{genesis}, messages_{messages} {}

  std::vector<Finding> all() {
    for (const std::string& url : target_.urls) {
      if (auto opened = check_server(url)) connections_.push_back(std::move(opened));
    }
    if (connections_.empty()) {
      add(Kind::fault, "no NATS server accepts this one; the rest was not checked");
      return std::move(findings_);
    }
    connection_ = connections_.front();
    if (const auto info = check_stream()) {
      check_settings(*info);
      check_formats(*info);
      check_replicas(*info);
      check_permissions();
      check_contents();
      compare_all_replicas(*info);
    }
    return std::move(findings_);
  }

 private:
  void add(Kind kind, std::string text) { findings_.push_back({kind, std::move(text)}); }

  /// Returns a connection; null if there is none.
  std::shared_ptr<jetstream::Connection> check_server(const std::string& url) {
    const auto greeting = greeting_of(url, kPatience * 2);
    if (!greeting) {
      add(Kind::fault, fmt::format("{}: {}", url, greeting.error()));
      return nullptr;
    }
    auto connection = jetstream::Connection::open(*ServerUrls::parse(url, kSchemes), target_.credentials,
                                                  nullptr, jetstream::Retry::never);
    if (!connection) {
      add(Kind::fault, connection_words(url, connection.error().reason, *greeting, *target_.credentials));
      return nullptr;
    }
    add(Kind::ok, fmt::format("{}: nats-server {}, {}", url, greeting->version, greeting->name));
    if (!greeting->jetstream)
      add(Kind::fault, fmt::format("{}: JetStream is off; switch it on in its configuration", url));
    if (const auto small = jetstream::small_payload(greeting->max_payload)) {
      add(Kind::fault, fmt::format("{}: {}", url, *small));
    }
    if (!at_least(greeting->version, 2, 9)) {
      add(Kind::fault,
          fmt::format("{}: nats-server {} has no Direct Get; take 2.9 or later", url, greeting->version));
    } else if (!at_least(greeting->version, 2, 10)) {
      note_once(
          "nats-server 2.9 has its files written to the disk every 2 minutes: what was acknowledged outlives "
          "any one host, and up to 2 minutes of it are lost if all replicas lose power at once; 2.10 can "
          "write at once (jetstream: sync_interval: always)");
    } else {
      note_once(
          "acknowledged edits outlive a power cut of all hosts only if each NATS server has jetstream: "
          "sync_interval: always; its default writes files to the disk every 2 minutes");
    }
    return *std::move(connection);
  }

  void note_once(std::string text) {
    const bool there = std::any_of(findings_.begin(), findings_.end(),
                                   [&](const Finding& finding) { return finding.text == text; });
    if (!there) add(Kind::note, std::move(text));
  }

  std::optional<jetstream::StreamInfo> check_stream() {
    const auto until = std::chrono::steady_clock::now() + 5s;
    for (;;) {
      auto info = ask_stream_info(*connection_, target_.names);
      if (info) {
        const std::chrono::sys_seconds made{std::chrono::seconds{info->state.created_ns / 1'000'000'000}};
        add(Kind::ok, fmt::format("stream {}: messages {} to {}, made {}", target_.names.stream,
                                  info->state.first, info->state.last, utc_time(made, "%Y-%m-%dT%H:%M:%SZ")));
        return *std::move(info);
      }
      const StreamFailure failure = failure_of(info.error(), target_.names);
      const bool said = std::holds_alternative<jetstream::ApiError>(info.error());
      if (failure.kind == StreamFailure::Kind::refused || std::chrono::steady_clock::now() > until) {
        std::string text = failure.reason;
        if (!said && failure.kind != StreamFailure::Kind::refused) {
          text +=
              ": JetStream is off, or the stream has no leader: most of its replicas do not run, or do not "
              "reach each other";
        }
        add(Kind::fault, std::move(text));
        return std::nullopt;
      }
      std::this_thread::sleep_for(kBetweenTries);
    }
  }

  void check_settings(const jetstream::StreamInfo& info) {
    const auto others =
        jetstream::differences(info.settings, jetstream::wanted_settings(target_.names, target_.replicas));
    for (const jetstream::SettingDifference& each : others) {
      std::string text = fmt::format("{}: {}", target_.names.stream, to_string(each));
      if (each.name == "max_age" || each.name == "max_bytes") {
        text += "; a server that was away for longer than the log is kept takes all from a peer";
      }
      add(Kind::fault, std::move(text));
    }
    if (others.empty())
      add(Kind::ok, fmt::format("{}: all settings are as they should be", target_.names.stream));
  }

  void check_formats(const jetstream::StreamInfo& info) {
    const cluster::EnabledFormats& enabled = info.state.enabled;
    if (!enabled.understood) {
      add(Kind::fault,
          fmt::format(
              "{}: {}: a talusd of this version stops before the first message that it does not know; "
              "it should be as \"log format 2 from message 1000\", or is for a newer talusd",
              target_.names.stream, formats_line(info)));
      return;
    }
    add(enabled.has_newer() ? Kind::note : Kind::ok,
        fmt::format("{}: {}", target_.names.stream, formats_line(info)));
  }

  void check_replicas(const jetstream::StreamInfo& info) {
    if (info.leader.empty()) {
      if (target_.replicas > 1) add(Kind::fault, fmt::format("{} has no leader", target_.names.stream));
      return;
    }
    std::size_t current = 1;
    for (const jetstream::ReplicaState& replica : info.replicas) {
      const bool well = replica.current && !replica.offline && replica.lag == 0;
      if (replica.current && !replica.offline) ++current;
      if (well) continue;
      add(Kind::note,
          fmt::format("replica at {}: {}, {} messages behind, last contact {:.1f} s ago", replica.name,
                      replica.offline   ? "offline"
                      : replica.current ? "current"
                                        : "not current",
                      replica.lag, std::chrono::duration<double>{replica.active}.count()));
    }
    const std::size_t all = info.replicas.size() + 1;
    if (current * 2 <= all) {
      add(Kind::fault, fmt::format("{}: {} of {} replicas are current, and edits need most of them",
                                   target_.names.stream, current, all));
    } else if (current < all) {
      add(Kind::note, fmt::format("{}: {} of {} replicas are current: if {} more are lost, edits stop",
                                  target_.names.stream, current, all, current - all / 2));
    } else {
      add(Kind::ok, fmt::format("leader {}, all {} replicas current", info.leader, all));
    }
  }

  void check_permissions() {
    if (const auto done = connection_->try_publish(target_.names.log, kPatience * 4); !done) {
      add(Kind::fault, fmt::format("cannot publish to {}: {}", target_.names.log, done.error().reason));
    } else {
      add(Kind::ok, fmt::format("may publish to {}", target_.names.log));
    }
    const auto began = std::chrono::steady_clock::now();
    const auto listens = connection_->subscribe(
        target_.names.tail, [](const jetstream::ReceivedMessage&) {}, 1, 1 << 20);
    const auto flushed = connection_->flush(kPatience * 2);
    if (!listens || !flushed) {
      add(Kind::fault, fmt::format("cannot subscribe to {}: {}", target_.names.tail,
                                   (listens ? flushed : listens).error().reason));
    } else if (const std::string denied = connection_->await_denial(began, kDenialIn); !denied.empty()) {
      add(Kind::fault, fmt::format("cannot subscribe to {}: {}", target_.names.tail, denied));
    } else {
      add(Kind::ok, fmt::format("may subscribe to {}", target_.names.tail));
    }
    // An empty message, which servers ignore.
    const auto tried = std::chrono::steady_clock::now();
    (void)connection_->send(target_.names.tail, target_.names.tail + ".check", "");
    (void)connection_->flush(kPatience * 2);
    if (connection_->await_denial(tried, kDenialIn).empty()) {
      add(Kind::note, fmt::format("may publish to {}, and so could send false edits to servers; forbid it to "
                                  "this user and all others in NATS' permissions",
                                  target_.names.tail));
    }
  }

  void check_contents() {
    if (const auto fits = check_world(*connection_, target_, genesis_); !fits) {
      add(Kind::fault, fits.error());
      return;
    }
    ProgressBar bar{"reading the log", "messages"};
    const auto contents = read_contents(*connection_, target_, genesis_.identity, messages_,
                                        [&](std::uint64_t /*done*/, std::uint64_t all) {
                                          bar.expect(all);
                                          bar.advance(1);
                                        });
    if (!contents) {
      add(Kind::fault, contents.error());
      return;
    }
    for (const Contents::UnreadMessage& each : contents->unread) add_unread(each, contents->enabled);
    if (contents->unread_count > contents->unread.size()) {
      add(Kind::note,
          fmt::format("{} more messages cannot be read", contents->unread_count - contents->unread.size()));
    }
    if (contents->unread.empty() && contents->first <= contents->last) {
      add(Kind::ok, fmt::format("messages {} to {} can be read, and are of world {}", contents->first,
                                contents->last, to_string(genesis_.identity.fingerprint)));
    }
  }

  void compare_all_replicas(const jetstream::StreamInfo& info) {
    if (info.replicas.empty()) return;
    ReplicaQuestions questions;
    std::size_t asked = 0;
    questions.ask = [&](const std::string& question) -> tl::expected<ReplicaAnswer, std::string> {
      const auto reply = connections_[asked++ % connections_.size()]->request(target_.names.direct_get(),
                                                                              question, kPatience);
      if (!reply) return tl::unexpected{reply.error().reason};
      const jetstream::ReceivedMessage message{reply->get()};
      if (message.status() == kNoMessage) return ReplicaAnswer{};
      if (message.status() != 0)
        return tl::unexpected{fmt::format("no replica answers (status {})", message.status())};
      return ReplicaAnswer{message.sequence(), std::string{message.text()}};
    };
    questions.info = [&]() -> std::optional<jetstream::StreamInfo> {
      auto asked_now = ask_stream_info(*connection_, target_.names);
      if (!asked_now) return std::nullopt;
      return *std::move(asked_now);
    };
    questions.pause = [] { std::this_thread::sleep_for(kBetweenTries); };
    const auto lines = compare_replicas(questions, target_.names);
    if (!lines) {
      add(Kind::note,
          fmt::format("{}: the replicas were not compared: {}", target_.names.stream, lines.error()));
      return;
    }
    for (const std::string& line : *lines) {
      add(Kind::fault, fmt::format("{}: the replicas differ: {}; see \"The stream is lost\" in CLUSTER.md",
                                   target_.names.stream, line));
    }
    if (lines->empty()) add(Kind::ok, "all replicas that answer have the same newest messages");
  }

  void add_unread(const Contents::UnreadMessage& unread, const cluster::EnabledFormats& enabled) {
    const bool stops =
        unread.fault.kind == cluster::MessageFault::Kind::newer && enabled.is_newer_at(unread.sequence);
    if (stops || unread.sequence == 1) {
      add(Kind::fault, fmt::format("message {}: {}; a talusd of this version stops before it{}",
                                   unread.sequence, unread.fault.reason, remedy_of(unread.fault)));
    } else {
      add(Kind::note,
          fmt::format("message {}: {}; all servers pass over it", unread.sequence, unread.fault.reason));
    }
  }

  const Target& target_;
  const cluster::Genesis& genesis_;
  const std::uint64_t messages_;
  std::vector<std::shared_ptr<jetstream::Connection>> connections_;  // to each server that accepted this one
  std::shared_ptr<jetstream::Connection> connection_;                // the first of connections_
  std::vector<Finding> findings_;
};

std::string_view word_of(Kind kind) {
  switch (kind) {
    case Kind::ok:
      return "ok";
    case Kind::note:
      return "note";
    case Kind::fault:
      break;
  }
  return "fault";
}

}  // namespace

std::vector<Finding> check(const Target& target, const cluster::Genesis& genesis, std::uint64_t messages) {
  return Checker{target, genesis, messages}.all();
}

bool any_fault(const std::vector<Finding>& findings) {
  return std::any_of(findings.begin(), findings.end(),
                     [](const Finding& finding) { return finding.kind == Kind::fault; });
}

std::string finding_lines(const std::vector<Finding>& findings) {
  std::string lines;
  for (const Finding& finding : findings)
    lines += fmt::format("{}: {}\n", word_of(finding.kind), finding.text);
  return lines;
}

}  // namespace talus::server::cluster_tool
