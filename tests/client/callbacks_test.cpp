// Every callback of a client may call it: each of them here sets Views, closes the client, connects it anew
// or destroys it, in a session that has something of everything.
#include <map>
#include <random>

#include <asio/co_spawn.hpp>
#include <asio/detached.hpp>
#include <asio/use_awaitable.hpp>
#include <catch2/catch.hpp>

#include "peer.h"

namespace talus::client {
namespace {

using namespace testing;

enum class Where : std::uint8_t {
  connected,
  chunk,
  column,  // on_chunk too, in the middle of a UniformColumn
  left_view,
  error,
  complete,
  got,
  heights,
  pong,
  disconnect,  // and the client tries to come back
  reconnect,
  lost,  // and it does not
};
constexpr std::array kPlaces{Where::connected, Where::chunk,      Where::column,    Where::left_view,
                             Where::error,     Where::complete,   Where::got,       Where::heights,
                             Where::pong,      Where::disconnect, Where::reconnect, Where::lost};

enum class What : std::uint8_t { set_view, there_and_back, close, connect_anew, destroy, replace };
constexpr std::array kActions{What::set_view,     What::there_and_back, What::close,
                              What::connect_anew, What::destroy,        What::replace};

constexpr std::uint16_t kHigh = 8;  // chunks up and down: a column of 17

View around(std::int64_t chunk_x) {
  View view;
  view.centre = {chunk_x * kChunkSize, 0, 0};
  view.horizontal_radius = 1;
  view.vertical_radius = kHigh;
  return view;
}

bool is_in_column(const ChunkKey& key) {
  return key.coord.x == 0 && key.coord.z == 1;
}

/// A client and its server. The server answers everything once and then hangs up, for three connections.
class Session {
 public:
  void run(const std::function<void(Session&, Where)>& act) {
    act_ = act;
    make_client();
    connect();
    asio::co_spawn(
        io_, [this] { return serve(); }, asio::detached);
    io_.run_for(std::chrono::seconds{10});
    REQUIRE(io_.stopped());
    CHECK(open_ == 0);  // every handler was called
  }

  void set_view(const View& view) {
    const auto before = std::exchange(view_, view);
    ++views_set_;
    if (!client_->set_view(view)) view_ = before;
  }
  void there_and_back() {
    const View here = view_;
    set_view(around(40));
    set_view(around(1));
    set_view(here);
  }
  void close() {
    client_->close();
    end();
  }
  void connect_anew() {
    client_->close();
    forget();
    connect();
  }
  void destroy() {
    client_.reset();
    end();
  }
  void replace() {
    Client another{io_.get_executor(), options(), events()};
    *client_ = std::move(another);
    forget();
    connect();
  }

 private:
  static Options options() {
    Options options;
    options.reconnect.max_attempts = 1;
    options.reconnect.first_delay = std::chrono::milliseconds{1};
    return options;
  }

  void make_client() { client_.emplace(io_.get_executor(), options(), events()); }

  // Nobody connects any more: the server's wait ends, and with it the test.
  void end() {
    forget();
    peer_.stop_listening();
  }

  void forget() {
    held_.clear();
    silent_ = true;
    ++life_;
  }

  Events events() {
    Events events;
    events.on_chunk = [this](const ReceivedChunk& chunk) {
      CHECK_FALSE(silent_);
      CHECK(ViewShape{view_}.covers(chunk.key));
      held_[chunk.key] = {chunk.chunk, views_set_};
      if (chunk.key == key_at(0, 2, 0)) set_view(around(1));  // something leaves
      act(is_in_column(chunk.key) ? Where::column : Where::chunk);
    };
    events.on_left_view = [this](ChunkKey key) {
      CHECK_FALSE(silent_);
      const auto held = held_.find(key);
      REQUIRE(held != held_.end());
      // Where the newest View has it again, it is still to come.
      CHECK_FALSE((ViewShape{view_}.covers(key) && held->second.views_set == views_set_));
      held_.erase(held);
      act(Where::left_view);
    };
    events.on_error = [this](const ClientError&) {
      CHECK_FALSE(silent_);
      act(Where::error);
    };
    events.on_view_complete = [this](const View& view) {
      CHECK_FALSE(silent_);
      CHECK(view.centre == view_.centre);
      ++open_;
      client_->ping([this](const auto&) { answered(Where::pong); });  // the server's sign to hang up
      act(Where::complete);
    };
    events.on_disconnect = [this](const ClientError&, bool retrying) {
      CHECK_FALSE(silent_);
      if (!retrying) forget();
      act(retrying ? Where::disconnect : Where::lost);
    };
    events.on_reconnect = [this](const WorldInfo&) {
      CHECK_FALSE(silent_);
      ask();
      act(Where::reconnect);
    };
    return events;
  }

  void connect() {
    ++open_;
    view_ = around(0);
    client_->connect("127.0.0.1", port_, [this, life = life_](const Result<WorldInfo>& world) {
      --open_;
      if (life != life_) {
        CHECK_FALSE(world.has_value());
        return;
      }
      if (!world) return;
      silent_ = false;
      set_view(around(0));
      ask();
      act(Where::connected);
    });
  }

  void ask() {
    if (!client_) return;
    open_ += 4;
    (void)client_->get(key_at(800, 0, 0), std::nullopt, [this](const auto&) { answered(Where::got); });
    (void)client_->get(key_at(900, 0, 0), std::nullopt, [this](const auto&) { answered(Where::got); });
    client_->get_heights({{1, 2}}, [this](const auto&) { answered(Where::heights); });
    client_->ping([this](const auto&) { answered(Where::pong); });
  }

  void answered(Where where) {
    --open_;
    if (client_) act(where);
  }

  void act(Where where) {
    if (client_) act_(*this, where);
  }

  asio::awaitable<void> serve() {
    for (int connection = 0; connection < 3; ++connection) {
      try {
        co_await peer_.welcome(1, 1U << 20, 1024);
        co_await answer_all();
        peer_.hang_up();
      } catch (const std::system_error&) {
        // The client hung up first, or nobody is to come any more.
      }
    }
    peer_.stop_listening();
  }

  asio::awaitable<void> answer_all() {
    std::uint32_t got = 0;
    std::vector<std::uint32_t> others;
    std::uint32_t heights = 0;
    std::optional<std::uint64_t> nonce;
    std::uint32_t number = 0;
    while (got == 0 || heights == 0 || !nonce || number == 0) {
      const auto* message = co_await peer_.receive();
      if (const auto* get = message->body_as_GetChunks()) {
        for (const auto* request : *get->requests()) {
          if (request->key().x() == 800) {
            got = request->id();
          } else if (request->key().x() < 900) {
            others.push_back(request->id());  // what the connection before left unanswered
          }
        }
      }
      if (const auto* asked = message->body_as_GetHeights()) heights = asked->id();
      if (const auto* ping = message->body_as_Ping()) nonce = ping->nonce();
      if (const auto* view = message->body_as_View()) number = view->number();
    }
    for (const int y : {0, 1, 2}) {
      co_await peer_.send(chunk_frame(0, key_at(0, y, 0), some_chunk(key_at(0, y, 0))));
      co_await peer_.send(chunk_frame(0, key_at(-1, y, 0), some_chunk(key_at(-1, y, 0))));
    }
    co_await peer_.send(column());
    co_await peer_.send(error_frame(wire::ErrorCode::internal, "a chunk was not to be had"));
    co_await peer_.send(protocol::make_frame([&](auto& b) { return wire::CreatePong(b, *nonce); }));
    co_await peer_.send(protocol::make_frame([&](auto& b) {
      return wire::CreateHeights(b, heights, b.CreateVector(std::vector<std::int32_t>{7}));
    }));
    co_await peer_.send(chunk_frame(got, key_at(800, 0, 0), some_chunk(key_at(800, 0, 0))));
    co_await peer_.send(column());
    co_await peer_.send(complete_frame(number));
    for (const auto id : others) co_await peer_.send(error_frame(wire::ErrorCode::internal, "no", id));
    co_await refuse_the_rest();
  }

  // Until a Ping: what is missing of a View is fetched anew, and not to be had.
  asio::awaitable<void> refuse_the_rest() {
    while (true) {
      const auto* message = co_await peer_.receive();
      if (message->body_as_Ping() != nullptr) co_return;
      if (const auto* view = message->body_as_View()) {
        const auto number = view->number();
        co_await peer_.send(complete_frame(number));
      } else if (const auto* get = message->body_as_GetChunks()) {
        std::vector<std::uint32_t> ids;
        for (const auto* request : *get->requests()) {
          if (request->key().x() < 900) ids.push_back(request->id());
        }
        for (const auto id : ids) co_await peer_.send(error_frame(wire::ErrorCode::internal, "no", id));
      }
    }
  }

  static protocol::Frame column() {
    const std::vector<wire::UniformRun> runs{{INT32_MIN, -1, 2}, {0, INT32_MAX, 0}};
    return protocol::make_frame(
        [&](auto& b) { return wire::CreateUniformColumn(b, 0, 1, 0, 0, b.CreateVectorOfStructs(runs)); });
  }

  asio::io_context io_;
  Peer peer_{io_};
  const std::string port_ = peer_.port();  // which it keeps when nobody listens there any more
  std::optional<Client> client_;
  std::function<void(Session&, Where)> act_;
  View view_;
  struct HeldChunk {
    std::shared_ptr<const Chunk> chunk;
    int views_set = 0;  // until it came
  };
  std::map<ChunkKey, HeldChunk> held_;  // delivered, and not left
  int views_set_ = 0;
  bool silent_ = true;  // no event may come: not connected, or closed
  int life_ = 0;        // raised when what was asked before is over
  int open_ = 0;        // handlers that are to be called
};

void perform(Session& session, What what) {
  switch (what) {
    case What::set_view:
      return session.set_view(around(2));
    case What::there_and_back:
      return session.there_and_back();
    case What::close:
      return session.close();
    case What::connect_anew:
      return session.connect_anew();
    case What::destroy:
      return session.destroy();
    case What::replace:
      return session.replace();
  }
}

}  // namespace

TEST_CASE("a callback may do anything to its client, and the rest holds") {
  for (const Where place : kPlaces) {
    for (const What what : kActions) {
      for (const int time : {1, 3}) {  // the callback's first call, or a later one
        CAPTURE(place, what, time);
        int calls = 0;
        bool reached = false;
        Session session;
        session.run([&](Session& s, Where where) {
          if (where != place || ++calls != time) return;
          reached = true;
          perform(s, what);
        });
        CHECK((reached || time > 1));
      }
    }
  }
}

TEST_CASE("a client whose callbacks set Views at random receives only events of the newest View") {
  for (unsigned seed = 1; seed <= 40; ++seed) {
    CAPTURE(seed);
    std::mt19937 random{seed};
    int views = 0;
    Session session;
    session.run([&](Session& s, Where) {
      if (views < 100 && random() % 3 == 0) {
        ++views;
        s.set_view(around(static_cast<int>(random() % 4)));
      }
    });
    CHECK(views > 0);
  }
}

}  // namespace talus::client
