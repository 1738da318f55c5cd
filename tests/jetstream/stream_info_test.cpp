// What JetStream answers, right and wrong.
#include <catch2/catch.hpp>

#include "cluster/jetstream/stored_message.h"
#include "cluster/jetstream/stream_info.h"
#include "cluster/jetstream/stream_settings.h"

using namespace talus::server::jetstream;
using talus::server::StreamFailure;

namespace {

using namespace std::chrono_literals;

const std::string kAnswer = R"({"type":"io.nats.jetstream.api.v1.stream_info_response",
  "config":{"name":"TALUS_x","deny_purge":true},"created":"2026-11-26T04:18:20.5Z",
  "state":{"messages":3,"bytes":99,"first_seq":2,"first_ts":"2026-11-26T04:18:21Z","last_seq":4},
  "cluster":{"name":"talus","leader":"n1","replicas":[{"name":"n2","current":true,"active":5,"lag":7}]}})";

}  // namespace

TEST_CASE("the leader's answer is read") {
  const auto info = parse_stream_info(kAnswer);
  REQUIRE(info);
  CHECK(info->state.first == 2);
  CHECK(info->state.last == 4);
  CHECK(info->state.created_ns == 1'795'666'700'500'000'000);
  CHECK(info->leader == "n1");
  REQUIRE(info->replicas.size() == 1);
  CHECK(info->replicas[0].name == "n2");
  CHECK(info->replicas[0].current);
  CHECK(info->replicas[0].lag == 7);
  CHECK(info->settings["deny_purge"] == true);
  CHECK(info->state.bytes == 99);
  CHECK(info->state.enabled == talus::server::cluster::EnabledFormats{});
  CHECK(info->description.empty());
}

TEST_CASE("a message that the leader gives is read, and nothing else is taken for one") {
  const auto stored = parse_stored_message(
      R"({"message":{"subject":"s","seq":7,"data":"AP8=","time":"2026-11-26T04:18:20.5Z"}})");
  REQUIRE(stored);
  CHECK(stored->sequence == 7);
  CHECK(stored->bytes == std::vector{std::byte{0}, std::byte{255}});
  CHECK(stored->time_ns == 1'795'666'700'500'000'000);
  const auto empty = parse_stored_message(R"({"message":{"seq":8,"time":"2026-11-26T04:18:20Z"}})");
  REQUIRE(empty);
  CHECK(empty->bytes.empty());
  const auto missing =
      parse_stored_message(R"({"error":{"code":404,"err_code":10037,"description":"no message found"}})");
  REQUIRE_FALSE(missing);
  CHECK(missing.error().code == kMessageNotFound);
  for (const auto* text : {"", "{}", "[]", R"({"message":7})", R"({"message":{}})",
                           R"({"message":{"seq":0,"data":"","time":"2026-11-26T04:18:20Z"}})",
                           R"({"message":{"seq":7,"data":"?","time":"2026-11-26T04:18:20Z"}})",
                           R"({"message":{"seq":7,"data":"","time":"today"}})"}) {
    CHECK_FALSE(parse_stored_message(text));
  }
}

TEST_CASE("the format that the stream's settings enable is read") {
  const auto info = parse_stream_info(
      R"({"config":{"description":"log format 2 from message 7"},"created":"2026-11-26T04:18:20Z","state":{"messages":0,"last_seq":4}})");
  REQUIRE(info);
  CHECK(info->state.enabled == talus::server::cluster::EnabledFormats{{{2, 7}}, true});
  CHECK(info->description == "log format 2 from message 7");
}

TEST_CASE(
    "a leader that reaches too few servers has no majority, and neither has a stream without a leader") {
  StreamInfo info;
  CHECK(has_majority(info));  // one server alone
  info.leader = "n1";
  info.replicas = {{"n2", true, false, 0, 1s}, {"n3", true, false, 0, 9s}};
  CHECK(has_majority(info));
  info.replicas[0].active = 5s;
  CHECK_FALSE(has_majority(info));
  info.replicas[1] = {"n3", true, true, 0, 0s};
  CHECK_FALSE(has_majority(info));
  info.replicas[0].active = 0s;
  CHECK(has_majority(info));
  info.leader.clear();
  CHECK_FALSE(has_majority(info));
}

TEST_CASE("a stream without messages begins after its last one") {
  const auto info = parse_stream_info(
      R"({"created":"2026-11-26T04:18:20Z","state":{"messages":0,"first_seq":0,"last_seq":4}})");
  REQUIRE(info);
  CHECK(info->state.first == 5);
}

TEST_CASE("a time is one that 64 bits of nanoseconds hold") {
  CHECK(nanoseconds_of("1970-01-01T00:00:01.5Z") == 1'500'000'000);
  CHECK(nanoseconds_of("2261-12-31T23:59:59Z"));
  for (const auto* text :
       {"1969-12-31T23:59:59Z", "2262-12-31T00:00:00Z", "9999-01-01T00:00:00Z", "", "now"}) {
    CHECK_FALSE(nanoseconds_of(text));
  }
}

TEST_CASE("an invalid answer of JetStream is an error") {
  for (std::size_t length = 0; length < kAnswer.size(); ++length) {
    CHECK_FALSE(parse_stream_info(kAnswer.substr(0, length)));
  }
  for (const auto* text :
       {"[]", "3", "{}", R"({"created":3,"state":{"last_seq":1}})",
        R"({"created":"x","state":{"last_seq":1}})", R"({"created":"2026-11-26T04:18:20Z","state":[]})"}) {
    CHECK_FALSE(parse_stream_info(text));
  }
  // Members of other types are as if they were missing.
  CHECK(parse_stream_info(R"({"created":"2026-11-26T04:18:20Z","cluster":[],"config":3,
                              "state":{"messages":"x","first_seq":null,"last_seq":1}})"));
}

TEST_CASE("a stream that is missing, and JetStream switched off, are for a person; the rest goes over") {
  const auto kind = [](int code) {
    const auto answer = parse_answer(R"({"error":{"code":400,"err_code":)" + std::to_string(code) +
                                     R"(,"description":"no"}})");
    REQUIRE_FALSE(answer);
    CHECK(answer.error().code == code);
    return failure_of(answer.error(), "TALUS_x").kind;
  };
  CHECK(kind(kStreamNotFound) == StreamFailure::Kind::refused);
  CHECK(kind(kNotEnabled) == StreamFailure::Kind::refused);
  CHECK(kind(10008) == StreamFailure::Kind::unavailable);
}

TEST_CASE("a setting that NATS does not change is named first, and nobody is told to change it") {
  const StreamNames names{"TALUS_x", "talus.x.log", "talus.x.tail"};
  const nlohmann::json mirror{{"name", "TALUS_x"}, {"mirror", {{"name", "OTHER"}}}, {"storage", "file"}};
  CHECK_THAT(other_settings(mirror, names, 3).value_or(""),
             Catch::Contains(R"(mirror is {"name":"OTHER"} and should be null, which NATS cannot change)") &&
                 !Catch::Contains("by the program nats"));
  nlohmann::json memory = wanted_settings(names, 3);
  memory["allow_direct"] = false;
  memory["storage"] = "memory";
  CHECK_THAT(other_settings(memory, names, 3).value_or(""),
             Catch::Contains("storage is \"memory\" and should be \"file\"") &&
                 Catch::Contains("delete the stream if it holds no edits") &&
                 Catch::Contains("if it holds some, make a new one (CLUSTER.md, \"A new stream\")"));
  memory["storage"] = "file";
  CHECK_THAT(other_settings(memory, names, 3).value_or(""),
             Catch::Contains("allow_direct is false and should be true; change it by the program nats"));
}

TEST_CASE("each setting that differs is named with what it is and should be") {
  const StreamNames names{"TALUS_x", "talus.x.log", "talus.x.tail"};
  const nlohmann::json wanted = wanted_settings(names, 3);
  CHECK(differences(wanted, wanted).empty());
  for (const auto& [name, value] : wanted.items()) {
    nlohmann::json other = wanted;
    other[name] = "other";
    const auto found = differences(other, wanted);
    REQUIRE(found.size() == 1);
    CHECK(to_string(found[0]) == name + " is \"other\" and should be " + value.dump());
    other.erase(name);
    CHECK(differences(other, wanted).size() == 1);
  }
  nlohmann::json more = wanted;
  more["sealed"] = true;
  CHECK(differences(more, wanted).size() == 1);
  more["sealed"] = "no boolean";  // as if it were not there
  CHECK(differences(more, wanted).empty());
  more = wanted;
  more["mirror"] = {{"name", "y"}};
  CHECK(differences(more, wanted).size() == 1);
}

TEST_CASE("numbers that no message has are told from messages that were lost") {
  const std::string answer = R"({"state":{"last_seq":9,"deleted":[4,5,6,9],"lost":{"msgs":[6],"bytes":90}}})";
  CHECK(parse_unused(answer, 4) == 2);
  CHECK(parse_unused(answer, 6) == 0);
  CHECK(parse_unused(answer, 7) == 0);
  CHECK(parse_unused(answer, 9) == 1);
  CHECK(parse_unused(R"({"state":{"deleted":"4","lost":[4]}})", 4) == 0);
  CHECK_FALSE(parse_unused("{", 4));
}
