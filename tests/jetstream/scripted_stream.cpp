#include "scripted_stream.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "config/access/base64url.h"

namespace talus::nats_test {

using server::jetstream::NatsMessage;
using server::jetstream::NatsSubscription;

namespace {

void must(natsStatus status) {
  if (status != NATS_OK) throw std::runtime_error{natsStatus_GetText(status)};
}

std::string base64_of(std::string_view bytes) {
  std::string text = server::base64url_encode(bytes);
  std::ranges::replace(text, '-', '+');
  std::ranges::replace(text, '_', '/');
  while (text.size() % 4 != 0) text += '=';
  return text;
}

}  // namespace

ScriptedStream::ScriptedStream(server::jetstream::StreamNames names, NatsSettings settings)
    : names_{std::move(names)}, servers_{[&] {
        settings.servers = 1;
        settings.jetstream = false;
        return settings;
      }()} {
  natsConnection* made = nullptr;
  must(natsConnection_ConnectTo(&made, url().c_str()));
  connection_.reset(made);
  for (const std::string& subject : {names_.info(), names_.message_get(), names_.direct_get()}) {
    natsSubscription* subscription = nullptr;
    must(natsConnection_Subscribe(&subscription, made, subject.c_str(), &ScriptedStream::asked, this));
    subscriptions_.emplace_back(subscription);
    must(natsSubscription_SetOnCompleteCB(subscription, &ScriptedStream::ended, this));
  }
  must(natsConnection_Flush(made));
}

ScriptedStream::~ScriptedStream() {
  natsConnection_Close(connection_.get());
  subscriptions_end_.wait();  // until then messages are still handled
}

void ScriptedStream::ended(void* self) {
  static_cast<ScriptedStream*>(self)->subscriptions_end_.count_down();
}

void ScriptedStream::set(Script script) {
  const std::lock_guard lock{mutex_};
  script_ = std::move(script);
}

std::size_t ScriptedStream::asked_of_replicas() const {
  const std::lock_guard lock{mutex_};
  return asked_of_replicas_;
}

void ScriptedStream::asked(natsConnection* connection, natsSubscription* /*subscription*/, natsMsg* message,
                           void* self) {
  const NatsMessage owned{message};
  static_cast<ScriptedStream*>(self)->answer(
      connection, natsMsg_GetSubject(message),
      {natsMsg_GetData(message), static_cast<std::size_t>(natsMsg_GetDataLength(message))},
      natsMsg_GetReply(message));
}

void ScriptedStream::answer(natsConnection* connection, std::string_view subject, std::string_view text,
                            const char* reply) {
  if (reply == nullptr) return;
  const std::lock_guard lock{mutex_};
  const bool of_replicas = subject == names_.direct_get();
  if (!of_replicas && !script_.has_leader) return;
  if (subject == names_.info()) {
    const std::uint64_t last = script_.leader.empty() ? 0 : script_.leader.rbegin()->first;
    const std::string info = nlohmann::json{
        {"config", nlohmann::json::object()},
        {"created", "2026-01-01T00:00:00Z"},
        {"state", {{"messages", script_.leader.size()}, {"first_seq", 1}, {"last_seq", last}}},
        {"cluster",
         {{"leader", "n1"}}}}.dump();
    natsConnection_PublishString(connection, reply, info.c_str());
    return;
  }
  const std::uint64_t sequence = nlohmann::json::parse(text).at("seq");
  if (!of_replicas) {
    const auto found = script_.leader.find(sequence);
    const auto body =
        found == script_.leader.end()
            ? nlohmann::json{{"error", {{"err_code", 10037}, {"description", "no message found"}}}}
            : nlohmann::json{{"message",
                              {{"seq", sequence},
                               {"time", "2026-01-01T00:00:00Z"},
                               {"data", base64_of(found->second)}}}};
    natsConnection_PublishString(connection, reply, body.dump().c_str());
    return;
  }
  ++asked_of_replicas_;
  const auto found = script_.replicas.find(sequence);
  const bool is_there = found != script_.replicas.end();
  natsMsg* made = nullptr;
  const std::string data = is_there ? found->second : std::string{};
  if (natsMsg_Create(&made, reply, nullptr, data.data(), static_cast<int>(data.size())) != NATS_OK) return;
  const NatsMessage message{made};
  if (is_there) {
    natsMsgHeader_Set(made, "Nats-Stream", names_.stream.c_str());
    natsMsgHeader_Set(made, "Nats-Sequence", std::to_string(sequence).c_str());
    natsMsgHeader_Set(made, "Nats-Time-Stamp", script_.replicas_time.c_str());
  } else {
    natsMsgHeader_Set(made, "Status", "404");
  }
  natsConnection_PublishMsg(connection, made);
}

}  // namespace talus::nats_test
