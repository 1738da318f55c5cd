// RAII handles for libnats objects.
#pragma once

#include <memory>

#include <nats/nats.h>

namespace talus::server::jetstream {

template <auto destroy>
struct DestroyedBy {
  template <typename Object>
  void operator()(Object* object) const {
    destroy(object);
  }
};

using NatsOptions = std::unique_ptr<natsOptions, DestroyedBy<natsOptions_Destroy>>;
using NatsMessage = std::unique_ptr<natsMsg, DestroyedBy<natsMsg_Destroy>>;
using NatsSubscription = std::unique_ptr<natsSubscription, DestroyedBy<natsSubscription_Destroy>>;
using NatsInbox = std::unique_ptr<natsInbox, DestroyedBy<natsInbox_Destroy>>;
using JetStreamContext = std::unique_ptr<jsCtx, DestroyedBy<jsCtx_Destroy>>;
using PublishAck = std::unique_ptr<jsPubAck, DestroyedBy<jsPubAck_Destroy>>;

}  // namespace talus::server::jetstream
