// Streams of NATS servers of tests and benches. What fails throws std::runtime_error.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cluster/jetstream/jetstream_log.h"
#include "nats_server.h"

namespace talus::nats_test {

/// Bytes of a text.
[[nodiscard]] std::span<const std::byte> bytes_of(std::string_view text);
[[nodiscard]] std::string text_of(std::span<const std::byte> bytes);

/// A store's id, and so names, that is the same each time.
[[nodiscard]] server::jetstream::StreamNames test_names(std::uint64_t store = 1);

[[nodiscard]] server::ServerUrls urls_of(const std::string& list);

/// A connection that nothing is known of.
[[nodiscard]] std::shared_ptr<server::jetstream::Connection> connected_to(
    const std::string& urls, server::jetstream::Credentials credentials = {});

/// Of talusd_permissions().
[[nodiscard]] server::jetstream::Credentials as_talusd();

/// Makes the stream and waits until all replicas are there.
void make_stream(const NatsServers& servers, const server::jetstream::StreamNames& names,
                 std::uint64_t replicas);
/// Asks JetStream's API; the answer.
std::string ask(const NatsServers& servers, const std::string& subject, const std::string& text = {});

[[nodiscard]] std::unique_ptr<server::jetstream::JetStreamLog> open_log(
    const std::string& urls, const server::jetstream::StreamNames& names,
    server::jetstream::Credentials credentials = {});

/// The number of the newest message of each server's own replica.
[[nodiscard]] std::vector<std::uint64_t> last_of_each(const NatsServers& servers, const std::string& stream);

/// Publishes what all replicas have to refuse, as it expects another message to be the stream's last. By it a
/// replica of nats-server 2.9.10 that is killed and starts again takes its newest message twice.
void publish_to_be_refused(const NatsServers& servers, const std::string& subject, std::string_view text);

/// A message with the headers that NATS gives those of a stream, and its refusals, by somebody who is no NATS
/// server.
void send_as_stream(const NatsServers& servers, const std::string& subject, const std::string& stream,
                    std::uint64_t sequence, std::string_view text);

}  // namespace talus::nats_test
