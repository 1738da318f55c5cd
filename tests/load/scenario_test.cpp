// talus-load against talusd: short runs of every kind, in which all that comes is right. Never how fast.
#include <algorithm>
#include <catch2/catch.hpp>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "certificates.h"
#include "fault_proxy.h"
#include "scratch_directory.h"
#include "server_process.h"

using namespace talus;
using namespace talus::load;
using e2e::ProgramResult;
using e2e::ServerProcess;
using Words = std::vector<std::string>;

namespace {

ProgramResult run_load(std::uint16_t port, const Words& more) {
  Words words{"--connect", "127.0.0.1:" + std::to_string(port), "--drain", "60", "--verify", "20"};
  words.insert(words.end(), more.begin(), more.end());
  return e2e::run_program(TALUS_LOAD_PATH, words);
}

/// All that came was right, and something did.
void check_clean(const Words& more, const e2e::Settings& settings = {}) {
  const ServerProcess server{settings};
  Words words = more;
  for (const char* threshold : {"wrong>0", "errors>0", "disconnects>0", "unanswered>0", "chunks_per_s==0"}) {
    words.insert(words.end(), {"--fail-if", threshold});
  }
  const ProgramResult ended = run_load(server.port(), words);
  INFO(ended.out);
  INFO(ended.err);
  CHECK(ended.status == 0);
}

const Words kTwenty{"--players", "20", "--duration", "2", "--radius", "3", "--vertical", "2"};

// A closed loop asks as fast as it is answered.
const e2e::Settings kNoRates{{"TALUS_RATES_SESSION_CHUNKS", "0"},   {"TALUS_RATES_SESSION_BYTES", "0"},
                             {"TALUS_RATES_SESSION_REQUESTS", "0"}, {"TALUS_RATES_ADDRESS_CHUNKS", "0"},
                             {"TALUS_RATES_ADDRESS_BYTES", "0"},    {"TALUS_RATES_ADDRESS_REQUESTS", "0"}};

Words twenty(const Words& more) {
  Words words = kTwenty;
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

std::string said(const ProgramResult& ended) {
  return ended.out + ended.err;
}

}  // namespace

TEST_CASE("players of all kinds get what is right") {
  check_clean(twenty({"--model", "mixed"}));
}

TEST_CASE("players of all kinds get what is right by WebSocket, slow readers too") {
  ServerProcess server{{}, {"--http", "127.0.0.1:0"}};
  for (const Words& kind : {Words{"--model", "mixed"}, Words{"--churn", "0.5"}, Words{"--slow", "2"}}) {
    Words words = twenty(kind);
    words.insert(words.end(), {"--connect", "ws://127.0.0.1:" + std::to_string(server.http_port())});
    for (const char* threshold : {"wrong>0", "errors>0", "unanswered>0", "chunks_per_s==0"}) {
      words.insert(words.end(), {"--fail-if", threshold});
    }
    const ProgramResult ended = run_load(server.port(), words);
    INFO(said(ended));
    CHECK(ended.status == 0);
  }
}

TEST_CASE("players that fly in groups get what is right") {
  check_clean(twenty({"--model", "fly", "--groups", "4", "--speed", "60", "--threads", "2"}));
}

TEST_CASE("players that walk to and fro over borders get what is right") {
  check_clean(twenty({"--model", "walk", "--speed", "300", "--every-tick"}));
}

TEST_CASE("players with a horizon get every chunk of its rings once, also while they fly and jump") {
  for (const char* model : {"stand", "fly", "teleport"}) {
    CAPTURE(model);
    check_clean({"--players", "4", "--duration", "2", "--radius", "2", "--vertical", "1", "--horizon", "40",
                 "--model", model, "--speed", "200", "--dwell", "0.5", "--drain", "60"});
  }
}

TEST_CASE("players that jump get what is right") {
  check_clean(twenty({"--model", "teleport", "--dwell", "0.5"}));
}

TEST_CASE("players that meet in one place get what is right") {
  check_clean(twenty({"--model", "swarm", "--speed", "500"}));
}

TEST_CASE("players that are cut off and come back get what is right") {
  check_clean(twenty({"--model", "mixed", "--churn", "0.5"}));
}

TEST_CASE("players of all kinds get what is right by TLS") {
  const ScratchDirectory scratch;
  const TestCertificate own = make_certificate(1);
  const std::string certificate = scratch.write("c.pem", own.certificate);
  const ServerProcess server{
      {{"TALUS_TLS_CERTIFICATE", certificate}, {"TALUS_TLS_KEY", scratch.write("k.pem", own.key)}}};
  Words words = twenty({"--model", "mixed", "--churn", "0.5", "--slow", "2", "--ca", certificate});
  for (const char* threshold : {"wrong>0", "unanswered>0", "errors>0", "disconnects>0", "chunks_per_s==0"}) {
    words.insert(words.end(), {"--fail-if", threshold});
  }
  const ProgramResult ended = run_load(server.port(), words);
  INFO(said(ended));
  CHECK(ended.status == 0);
}

TEST_CASE("load by TLS without the authority says what to give") {
  const ScratchDirectory scratch;
  const TestCertificate own = make_certificate(1);
  const ServerProcess server{{{"TALUS_TLS_CERTIFICATE", scratch.write("c.pem", own.certificate)},
                              {"TALUS_TLS_KEY", scratch.write("k.pem", own.key)}}};
  const ProgramResult ended = run_load(server.port(), twenty({"--tls"}));
  CHECK(ended.status == 1);
  CHECK_THAT(ended.err, Catch::Contains("certificate verify failed") && Catch::Contains("--ca FILE"));
}

TEST_CASE("requests get what is right") {
  check_clean({"--players", "8", "--in-flight", "16", "--set", "64", "--duration", "2"}, kNoRates);
}

TEST_CASE("a greedy client and a slow one leave players their share") {
  check_clean(twenty({"--greedy", "1", "--slow", "2"}));
}

TEST_CASE("idle connections from several addresses are kept next to players") {
  check_clean(twenty({"--idle", "200", "--from-addresses", "4"}));
}

TEST_CASE("players follow a trace") {
  const ScratchDirectory scratch;
  std::ofstream{scratch.path() / "way"} << "0 0 0 0\n1 100 0 0\n2 100 40 90\n";
  check_clean(twenty({"--model", "trace:" + (scratch.path() / "way").string()}));
}

TEST_CASE("a threshold that holds ends the program with 1 and one line") {
  const ServerProcess server;
  const ProgramResult ended =
      run_load(server.port(), {"--players", "1", "--duration", "0.2", "--fail-if", "joins>0"});
  CHECK(ended.status == 1);
  CHECK(ended.err == "talus-load: --fail-if joins>0: joins is 1\n");
}

TEST_CASE("the results are written, and compared with earlier ones") {
  const ServerProcess server;
  const ScratchDirectory scratch;
  const std::string json = (scratch.path() / "run.json").string();
  const std::string plot = (scratch.path() / "run.svg").string();
  const Words little{"--players", "2", "--duration", "0.2", "--radius", "1", "--vertical", "1"};
  Words first = little;
  first.insert(first.end(), {"--json", json, "--plot", plot});
  REQUIRE(run_load(server.port(), first).status == 0);
  const auto written = nlohmann::json::parse(std::ifstream{json});
  CHECK(written["format"] == 2);
  CHECK(written["settings"]["players"] == 2);
  CHECK(written["figures"]["wrong"] == 0);
  CHECK(written["roles"]["walk"]["chunk_messages"].get<int>() +
            written["roles"]["walk"]["uniform_chunks"].get<int>() >=
        54);
  std::string begin;
  std::getline(std::ifstream{plot}, begin);
  CHECK(begin.find("<svg") == 0);

  Words second = little;
  second.insert(second.end(), {"--compare", json});
  const ProgramResult ended = run_load(server.port(), second);
  CHECK(ended.status == 0);
  CHECK(ended.out.find("compared with " + json) != std::string::npos);
}

TEST_CASE("builders see each other's acknowledged edits, also when connections are cut") {
  const ScratchDirectory scratch;
  const ServerProcess server{
      {{"TALUS_DATA", (scratch.path() / "data").string()}, {"TALUS_ACCESS_WITHOUT_TOKEN", "read,edit"}}};
  const std::string json = (scratch.path() / "run.json").string();
  const ProgramResult ended = run_load(server.port(), {"--players",    "6",
                                                       "--edits",      "20",
                                                       "--edit-group", "3",
                                                       "--duration",   "3",
                                                       "--radius",     "2",
                                                       "--vertical",   "1",
                                                       "--churn",      "2",
                                                       "--threads",    "2",
                                                       "--json",       json,
                                                       "--fail-if",    "wrong>0",
                                                       "--fail-if",    "unanswered>0",
                                                       "--fail-if",    "errors>0",
                                                       "--fail-if",    "edit_ack_max_ms==0",
                                                       "--fail-if",    "edit_arrival_max_ms==0",
                                                       "--fail-if",    "cuts==0"});
  INFO(said(ended));
  CHECK(ended.status == 0);
  const auto written = nlohmann::json::parse(std::ifstream{json});
  CHECK(written["figures"]["edits"].get<double>() >= 100);
  CHECK(written["figures"]["edits_missing"] == 0);
  CHECK(written["roles"]["build"]["edits"]["voxels"].get<int>() > 0);
}

TEST_CASE("builders in a closed loop send the next edit when one is answered") {
  const ScratchDirectory scratch;
  const ServerProcess server{
      {{"TALUS_DATA", (scratch.path() / "data").string()}, {"TALUS_ACCESS_WITHOUT_TOKEN", "read,edit"}}};
  const ProgramResult ended =
      run_load(server.port(), {"--players", "2", "--edit-in-flight", "2", "--duration", "0.5", "--radius",
                               "1", "--vertical", "1", "--fail-if", "wrong>0", "--fail-if", "edits<20"});
  INFO(said(ended));
  CHECK(ended.status == 0);
}

TEST_CASE("a model of the acknowledged edits has the server's chunks, and sees where one is unlike them") {
  const ScratchDirectory scratch;
  const ServerProcess server{
      {{"TALUS_WORLD", TALUS_SOURCE_DIR "/core/worlds/default.toml"},  // the model's, also under sanitizers
       {"TALUS_DATA", (scratch.path() / "data").string()},
       {"TALUS_ACCESS_WITHOUT_TOKEN", "read,edit"}}};
  const std::string edits = (scratch.path() / "edits").string();
  for (const char* const seed : {"1", "2"}) {
    const ProgramResult ended =
        run_load(server.port(), {"--players",  "4",  "--edits",  "40", "--edit-group", "2",
                                 "--duration", "1",  "--radius", "1",  "--vertical",   "1",
                                 "--churn",    "1",  "--seed",   seed, "--edits-file", edits,
                                 "--drain",    "120"});  // an edit without an answer is not in the file
    INFO(said(ended));
    REQUIRE(ended.status == 0);
  }
  const auto compare = [&] {
    return e2e::run_program(TALUS_EDITS_MODEL_PATH, {edits, "127.0.0.1", std::to_string(server.port())});
  };
  const ProgramResult same = compare();
  INFO(said(same));
  CHECK(same.status == 0);
  std::istringstream figures{same.out};
  std::uint64_t compared = 0, differing = 0, voxels = 0, revision = 0;
  figures >> compared >> differing >> voxels >> revision;
  CHECK(compared >= 2);
  CHECK(voxels > 100);

  std::vector<std::string> lines;
  std::ifstream file{edits};
  for (std::string line; std::getline(file, line);) lines.push_back(line);
  CHECK(lines.size() == revision);  // nobody else edits
  file.close();
  const auto check_unlike = [&](const std::vector<std::string>& changed, const std::string& why) {
    std::ofstream written{edits};
    for (const std::string& line : changed) written << line << '\n';
    written.close();
    const ProgramResult other = compare();
    CHECK(other.status == 1);
    CHECK(other.err.find(why) != std::string::npos);
  };
  const auto number = [](const std::string& line) { return std::stoull(line); };
  std::ranges::sort(lines, {}, number);
  const std::string newest = lines.back();
  // As if the server had lost an edit, done another, and done one that it did not acknowledge.
  std::vector<std::string> changed = lines;
  changed.push_back(std::to_string(revision + 1) + newest.substr(newest.find(' ')));
  check_unlike(changed, ": revision ");
  changed = lines;
  changed.back() = newest.substr(0, newest.rfind(' ')) + " 1";
  check_unlike(changed, ": hash ");
  changed = lines;
  changed.erase(changed.begin() + 1);
  check_unlike(changed, "no edit was acknowledged as revision 2, and one as revision 3");
}

TEST_CASE("a server that takes no edits fails a run of builders") {
  const ServerProcess server;
  const ProgramResult ended = run_load(server.port(), {"--players", "1", "--edits", "10", "--duration", "0.3",
                                                       "--radius", "1", "--vertical", "1"});
  CHECK(ended.status == 1);
  CHECK(ended.err.find("talus-load: no edit was acknowledged") == 0);
}

TEST_CASE("flipped bits are found") {
  const ServerProcess server;
  Faults flip;
  flip.flip_every = 9001;
  const FaultProxy proxy{server.port(), {}, flip};
  const ProgramResult ended =
      run_load(proxy.port(), {"--players", "1", "--duration", "1", "--model", "stand", "--verify", "100",
                              "--drain", "0.5", "--fail-if", "wrong>0"});
  INFO(said(ended));
  CHECK(ended.status == 1);
  CHECK(ended.err.find("--fail-if wrong>0") != std::string::npos);
}

TEST_CASE("connections that the network cuts are counted, and come back") {
  const ServerProcess server;
  Faults cut;
  cut.cut_after = 20'001;
  const FaultProxy proxy{server.port(), {}, cut, 4};
  const ProgramResult ended = run_load(
      proxy.port(), {"--players", "3", "--duration", "3", "--radius", "4", "--vertical", "2", "--fail-if",
                     "wrong>0", "--fail-if", "unanswered>0", "--fail-if", "disconnects!=3", "--fail-if",
                     "reconnects!=3", "--fail-if", "return_max_ms==0"});
  INFO(said(ended));
  CHECK(ended.status == 0);
}

TEST_CASE("a server that is not there is one line and 1") {
  const ProgramResult ended = e2e::run_program(TALUS_LOAD_PATH, {"--connect", "127.0.0.1:1"});
  CHECK(ended.status == 1);
  CHECK(ended.err.find("talus-load: 127.0.0.1:1: ") == 0);
  CHECK(std::count(ended.err.begin(), ended.err.end(), '\n') == 1);
}

TEST_CASE("a trace that is not there is named") {
  const ProgramResult ended = e2e::run_program(TALUS_LOAD_PATH, {"--model", "trace:/no/such"});
  CHECK(ended.status == 1);
  CHECK(ended.err.find("/no/such: cannot be read") != std::string::npos);
}
