#include "net/session_runner_impl.h"

namespace talus::server {

template class SessionRunner<TcpStream>;
template class SessionRunner<TlsStream>;

void start_session(AcceptedConnection accepted, const RunnerContextPtr& context) {
  const ConnectionId id = accepted.info.id;
  std::visit(
      [&](auto& stream) {
        using S = std::remove_reference_t<decltype(stream)>;
        const auto runner = SessionRunner<S>::make(std::move(stream), std::move(accepted.info),
                                                   std::move(accepted.slot), context);
        try {
          context->registry.add(id, runner);
          runner->start();
        } catch (...) {
          context->registry.remove(id);
          throw;
        }
      },
      accepted.stream);
}

}  // namespace talus::server
