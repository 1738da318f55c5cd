#include "commands/cluster/connection_words.h"

#include <fmt/format.h>

namespace talus::server::cluster_tool {
namespace {

/// Empty if the reason is clear by itself.
std::string_view advice_of(std::string_view reason, const Greeting& greeting,
                           const jetstream::Credentials& who) {
  const auto says = [&](std::string_view words) { return reason.find(words) != std::string_view::npos; };
  if (says("key values mismatch")) {
    return "cluster.key: is not the key of cluster.certificate; give the two that were made together";
  }
  if (greeting.tls && !who.tls)
    return "cluster.nats: this server requires TLS; write tls:// instead of nats://";
  if (!greeting.tls && who.tls) {
    return "cluster.nats: this server has no TLS; write nats://, or switch TLS on there (tls {} in its "
           "configuration)";
  }
  if (!who.tls) return "";
  if (says("mismatch")) {
    return "cluster.nats: the server's certificate is for another name or address; write one that the "
           "certificate names";
  }
  if (says("expired") || says("not yet valid")) {
    return "cluster.nats: the server's certificate is not valid now; renew it there, or set the clock right";
  }
  if (says("issuer") || says("self") || says("certificate signature") || says("certificate verify")) {
    return "cluster.ca: did not sign this server's certificate; give the PEM file of the authority that did";
  }
  if (!greeting.tls_verify || says("uthorization")) return "";
  // In TLS 1.3 a server that rejects a client's certificate only closes the connection.
  if (who.certificate.empty()) {
    return "cluster.certificate, cluster.key: are not set, and this server requires a certificate; give one "
           "that its authority has signed";
  }
  return "cluster.certificate: this server does not accept it; give one that its authority (ca_file there) "
         "has signed, for clients, and that is valid now";
}

}  // namespace

std::string connection_words(std::string_view url, std::string_view reason, const Greeting& greeting,
                             const jetstream::Credentials& who) {
  const std::string_view advice = advice_of(reason, greeting, who);
  const std::string_view why =
      reason.starts_with(url) && reason.size() > url.size() + 2 ? reason.substr(url.size() + 2) : reason;
  if (advice.empty()) return fmt::format("{}: {}", url, why);
  return fmt::format("{}: {} ({})", url, advice, why);
}

}  // namespace talus::server::cluster_tool
