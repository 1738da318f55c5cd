#include "app/joining_page.h"

#include <utility>

#include <fmt/format.h>

namespace talus::server {

OperatorAnswers joining_answers(std::shared_ptr<const JoinProgress> progress) {
  OperatorAnswers answers{
      [progress = std::move(progress)] {
        return fmt::format(
            "# HELP talus_cluster_joining 1 while the server has no store yet.\n"
            "# TYPE talus_cluster_joining gauge\n"
            "talus_cluster_joining 1\n"
            "# HELP talus_cluster_join_bytes Bytes of a peer's checkpoint: come, and in all.\n"
            "# TYPE talus_cluster_join_bytes gauge\n"
            "talus_cluster_join_bytes{{of=\"come\"}} {}\n"
            "talus_cluster_join_bytes{{of=\"all\"}} {}\n",
            progress->done.load(), progress->total.load());
      },
      [] { return true; }, [] { return Readiness{false, "joining: there is no store here yet"}; }, [] { return FlowsReport{}; }};
  answers.checkpoint = [](const http::Request&, const std::string&) -> asio::awaitable<http::Response> {
    co_return http::Response{503,
                             http::kPlainText,
                             "this server has no store yet; it takes one itself\n",
                             {{"Retry-After", "10"}}};
  };
  return answers;
}

}  // namespace talus::server
