#include "app/joining_page.h"

#include <utility>

#include <fmt/format.h>

namespace talus::server {

void JoinProgress::put_aside(const std::optional<AsideStore>& store) {
  const std::lock_guard lock{mutex_};
  aside_ = store;
}

std::optional<AsideStore> JoinProgress::aside() const {
  const std::lock_guard lock{mutex_};
  return aside_;
}

OperatorAnswers joining_answers(std::shared_ptr<const JoinProgress> progress) {
  OperatorAnswers answers{[progress] {
                            return fmt::format(
                                "# HELP talus_cluster_joining 1 while the server has no store yet.\n"
                                "# TYPE talus_cluster_joining gauge\n"
                                "talus_cluster_joining 1\n"
                                "# HELP talus_cluster_join_bytes Bytes of a peer's checkpoint; come: "
                                "received so far, all: its size.\n"
                                "# TYPE talus_cluster_join_bytes gauge\n"
                                "talus_cluster_join_bytes{{of=\"come\"}} {}\n"
                                "talus_cluster_join_bytes{{of=\"all\"}} {}\n",
                                progress->done.load(), progress->total.load());
                          },
                          [] { return true; },
                          [progress] {
                            return Readiness{
                                false, progress->aside()
                                           ? "joining: this server must not use its store and needs a peer's"
                                           : "joining: this server has no store yet"};
                          },
                          [] { return FlowsReport{}; }};
  answers.checkpoint = [progress = std::move(progress)](
                           const http::Request&, const std::string&,
                           const std::function<void()>&) -> asio::awaitable<http::Response> {
    const auto aside = progress->aside();
    http::Response response{503,
                            http::kPlainText,
                            aside ? "this server must not use its store; it takes a peer's store by itself\n"
                                  : "this server has no store yet; it takes a peer's store by itself\n",
                            {{"Retry-After", "10"}}};
    if (aside) response.fields.push_back({kAsideHeader, to_string(*aside)});
    co_return response;
  };
  return answers;
}

}  // namespace talus::server
