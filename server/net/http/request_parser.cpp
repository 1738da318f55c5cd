#include "net/http/request_parser.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <http_parser.h>

#include <talus/protocol/header_fields.h>

namespace talus::server::http {
namespace {

using protocol::same_name;

constexpr RequestError kMalformed{400, "this is not HTTP/1.1"};
constexpr RequestError kTargetTooLong{414, "the request's target is too long"};
constexpr RequestError kTooManyFields{431, "the request has too many header fields"};
constexpr RequestError kFieldTooLarge{431, "a header field is too large"};
constexpr RequestError kHeadTooLarge{431, "the request's header is too large"};
constexpr RequestError kBody{413, "a request may not have a body"};
constexpr RequestError kExpectation{417, "a request may not have a body to continue with"};
constexpr RequestError kVersion{400, "this server supports only HTTP/1.0 and HTTP/1.1"};
constexpr RequestError kNoHost{400, "an HTTP/1.1 request has exactly one Host field"};
constexpr RequestError kBareLineFeed{400, "a line ends with LF alone instead of CR LF"};
constexpr RequestError kFolded{400, "a header line begins with white space"};
constexpr RequestError kHost{400, "the Host field is not HOST or HOST:PORT"};
constexpr RequestError kFieldName{400, "a header field's name is not a token"};
constexpr RequestError kFieldValue{400, "a header field's value has a control character"};

// Debian's http_parser is compiled without its strict checks, so some are made here.

/// RFC 9110, 5.6.2.
bool is_token(std::string_view name) {
  constexpr std::string_view kMarks{"!#$%&'*+-.^_`|~"};
  return std::all_of(name.begin(), name.end(), [&](char c) {
    return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') ||
           kMarks.find(c) != std::string_view::npos;
  });
}

/// RFC 9110, 5.5.
bool is_value(std::string_view value) {
  return std::none_of(value.begin(), value.end(), [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return (byte < 0x20 && c != '\t') || byte == 0x7F;
  });
}

/// RFC 9112, 3.2: a host and an optional port, or nothing. Only the characters are checked.
bool is_host(std::string_view value) {
  constexpr std::string_view kMarks{"-._~!$&'()*+,;=%:[]"};
  return std::all_of(value.begin(), value.end(), [&](char c) {
    return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') ||
           kMarks.find(c) != std::string_view::npos;
  });
}

constexpr std::string_view kGet = "GET ";
constexpr std::string_view kGetPath = "GET /";
// Maximum size of a request that is kept for comparison with the next.
constexpr std::size_t kMaxKept = 1024;

/// Characters of a plain path and query: valid at every position.
constexpr std::array<bool, 256> kPlain = [] {
  std::array<bool, 256> plain{};
  for (const char c :
       std::string_view{"0123456789abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ/-._~?=&,;"}) {
    plain[static_cast<unsigned char>(c)] = true;
  }
  return plain;
}();

/// Reads every character: stopping at the first that is not plain costs twice as much.
bool is_plain(std::string_view text) {
  bool plain = true;
  for (const char c : text) plain &= kPlain[static_cast<unsigned char>(c)];
  return plain;
}

Method method_of(unsigned method) {
  if (method == HTTP_GET) return Method::get;
  if (method == HTTP_OPTIONS) return Method::options;
  return method == HTTP_HEAD ? Method::head : Method::other;
}

}  // namespace

std::string_view Request::path() const {
  std::string_view path{target};
  if (path.starts_with('/')) return path.substr(0, path.find('?'));
  const std::size_t scheme = path.find("://");
  const bool absolute = scheme != std::string_view::npos && (same_name(path.substr(0, scheme), "http") ||
                                                             same_name(path.substr(0, scheme), "https"));
  if (absolute) {
    path.remove_prefix(scheme + 3);
    path.remove_prefix(std::min(path.find_first_of("/?"), path.size()));
  }
  path = path.substr(0, path.find('?'));
  return absolute && path.empty() ? "/" : path;
}

std::optional<std::string_view> Request::query() const {
  const std::string_view whole{target};
  const std::size_t mark = whole.find('?');
  return mark == std::string_view::npos ? std::nullopt : std::optional{whole.substr(mark + 1)};
}

bool Request::has(std::string_view name) const {
  return std::any_of(fields.begin(), fields.end(),
                     [&](const Field& field) { return same_name(field.name, name); });
}

std::string Request::list(std::string_view name) const {
  std::string values;
  for (const Field& field : fields) {
    if (!same_name(field.name, name)) continue;
    if (!values.empty()) values += ", ";
    values += field.value;
  }
  return values;
}

std::string Request::bearer_token() const {
  constexpr std::string_view kScheme = "Bearer ";
  std::string credentials = list("Authorization");
  if (!same_name(std::string_view{credentials}.substr(0, kScheme.size()), kScheme)) return {};
  return credentials.erase(0, credentials.find_first_not_of(' ', kScheme.size()));
}

struct RequestParser::State {
  explicit State(const RequestBounds& wanted) : bounds{wanted} { begin(); }

  void begin() {
    head_bytes = 0;
    last = 0;
    in_value = true;
    whole = false;
  }

  /// A persistent connection usually asks for other targets with the same fields. If everything after the
  /// target equals the previous request, it is not parsed again, which would cost as much as finding a chunk.
  /// Returns the number of bytes of the request, or 0 if it must be parsed.
  std::size_t take_similar(std::string_view text) {
    if (after_target.empty() || !text.starts_with(kGetPath)) return 0;
    const std::size_t end = std::min(text.find(' ', kGetPath.size()), text.size());
    if (text.substr(end, after_target.size()) != after_target) return 0;
    const std::string_view target = text.substr(kGet.size(), end - kGet.size());
    const std::size_t bytes = end + after_target.size();
    if (target.size() > bounds.target_bytes || bytes > bounds.head_bytes || !is_plain(target)) return 0;
    request.target = target;
    head_bytes = bytes;
    whole = true;
    return bytes;
  }

  /// `text`: a whole valid request.
  void keep(std::string_view text) {
    const std::size_t end = text.starts_with(kGet) ? text.find(' ', kGet.size()) : std::string_view::npos;
    if (end != std::string_view::npos && text.size() <= kMaxKept) after_target = text.substr(end);
  }

  /// Resets the state before a request is parsed. Frees the memory of a long request.
  void forget() {
    http_parser_init(&parser, HTTP_REQUEST);
    parser.data = this;
    after_target.clear();
    if (request.target.size() + kept_fields > kMaxKept) request = {};
    kept_fields = 0;
    request.target.clear();
    request.fields.clear();
  }

  /// Rejects lines that http_parser accepts but a proxy in front may read differently, so that the two would
  /// see different requests. Every line must end with CR LF and must not begin with white space, as if it
  /// continued the line before (RFC 9112, 5.2).
  [[nodiscard]] std::optional<RequestError> wrong_line(std::string_view taken) {
    std::optional<RequestError> wrong;
    const auto is_space = [](char c) { return c == ' ' || c == '\t'; };
    if (last == '\n' && !taken.empty() && is_space(taken.front())) wrong = kFolded;
    for (std::size_t at = taken.find('\n'); at != std::string_view::npos && !wrong;
         at = taken.find('\n', at + 1)) {
      if ((at == 0 ? last : taken[at - 1]) != '\r')
        wrong = kBareLineFeed;
      else if (at + 1 < taken.size() && is_space(taken[at + 1]))
        wrong = kFolded;
    }
    if (!taken.empty()) last = taken.back();
    return wrong;
  }

  // Callbacks return the result to stop http_parser.
  int fail(const RequestError& why) {
    error = why;
    return 1;
  }

  int append_target(std::string_view part) {
    if (request.target.size() + part.size() > bounds.target_bytes) return fail(kTargetTooLong);
    request.target += part;
    return 0;
  }
  int append_name(std::string_view part) {
    if (in_value && request.fields.size() == bounds.fields) return fail(kTooManyFields);
    kept_fields += part.size();
    if (in_value) request.fields.emplace_back();
    in_value = false;
    return append(request.fields.back().name, part);
  }
  int append_value(std::string_view part) {
    in_value = true;
    kept_fields += part.size();
    return append(request.fields.back().value, part);
  }
  int append(std::string& text, std::string_view part) {
    const Field& field = request.fields.back();
    if (field.name.size() + field.value.size() + part.size() > bounds.field_bytes)
      return fail(kFieldTooLarge);
    text += part;
    return 0;
  }

  int end_of_head() {
    if (parser.http_major != 1) return fail(kVersion);
    std::size_t hosts = 0;
    for (Field& field : request.fields) {
      if (!is_token(field.name)) return fail(kFieldName);
      if (!is_value(field.value)) return fail(kFieldValue);
      // http_parser drops only the white space before the value.
      field.value.resize(protocol::trimmed(field.value).size());
      if (same_name(field.name, "Host")) {
        if (!is_host(field.value)) return fail(kHost);
        ++hosts;
      }
      if (same_name(field.name, "Expect")) return fail(kExpectation);
    }
    if (hosts > 1 || (hosts == 0 && parser.http_minor > 0)) return fail(kNoHost);
    const bool has_length = (parser.flags & F_CONTENTLENGTH) != 0 && parser.content_length > 0;
    if (has_length || parser.uses_transfer_encoding != 0) return fail(kBody);
    request.method = method_of(parser.method);
    // HTTP/1.0 has no upgrades (RFC 9110, 7.8). Bytes after the request may be meant for another protocol.
    const bool asks = parser.upgrade != 0;
    request.upgrade = asks && parser.http_minor > 0;
    request.keep_alive = http_should_keep_alive(&parser) != 0 && (!asks || request.upgrade);
    return 0;
  }

  int end_of_request() {
    whole = true;
    http_parser_pause(&parser, 1);  // the next bytes belong to the next request
    return 0;
  }

  static State& of(http_parser* parser) { return *static_cast<State*>(parser->data); }
  static const http_parser_settings& settings() {
    static const http_parser_settings kSettings = [] {
      http_parser_settings made;
      http_parser_settings_init(&made);
      made.on_url = [](http_parser* p, const char* at, std::size_t n) {
        return of(p).append_target({at, n});
      };
      made.on_header_field = [](http_parser* p, const char* at, std::size_t n) {
        return of(p).append_name({at, n});
      };
      made.on_header_value = [](http_parser* p, const char* at, std::size_t n) {
        return of(p).append_value({at, n});
      };
      made.on_headers_complete = [](http_parser* p) { return of(p).end_of_head(); };
      made.on_message_complete = [](http_parser* p) { return of(p).end_of_request(); };
      return made;
    }();
    return kSettings;
  }

  const RequestBounds bounds;
  http_parser parser{};
  Request request;
  std::string after_target;     // of the previous request; empty: do not compare
  std::size_t kept_fields = 0;  // bytes of names and values
  std::size_t head_bytes = 0;
  char last = 0;         // byte before the next one
  bool in_value = true;  // the next name begins a field
  bool whole = false;
  std::optional<RequestError> error;
};

RequestParser::RequestParser(const RequestBounds& bounds) : state_{std::make_unique<State>(bounds)} {}
RequestParser::~RequestParser() = default;

tl::expected<std::size_t, RequestError> RequestParser::feed(std::span<const std::byte> bytes) {
  State& state = *state_;
  if (state.error) return tl::make_unexpected(*state.error);
  if (state.whole) return 0;
  const auto offered = bytes.first(std::min(bytes.size(), state.bounds.head_bytes - state.head_bytes));
  if (offered.empty()) return 0;  // an empty input would end the message for http_parser
  const std::string_view text{reinterpret_cast<const char*>(offered.data()), offered.size()};
  const bool begins = state.head_bytes == 0;
  if (begins) {
    if (const std::size_t similar = state.take_similar(text)) return similar;
    state.forget();
  }
  const std::size_t taken = http_parser_execute(&state.parser, &State::settings(), text.data(), text.size());
  state.head_bytes += taken;
  const auto wrong = state.wrong_line(text.substr(0, taken));
  if (!state.error) state.error = wrong;
  if (state.error) return tl::make_unexpected(*state.error);
  if (!state.whole) {
    if (HTTP_PARSER_ERRNO(&state.parser) == HPE_HEADER_OVERFLOW)
      state.error = kHeadTooLarge;
    else if (HTTP_PARSER_ERRNO(&state.parser) != HPE_OK)
      state.error = kMalformed;
    else if (state.head_bytes == state.bounds.head_bytes)
      state.error = kHeadTooLarge;
    if (state.error) return tl::make_unexpected(*state.error);
  } else if (begins) {
    state.keep(text.substr(0, taken));
  }
  return taken;
}

bool RequestParser::has_request() const {
  return state_->whole;
}

bool RequestParser::mid_request() const {
  return state_->head_bytes > 0 && !state_->whole;
}

const Request& RequestParser::request() const {
  return state_->request;
}

std::size_t RequestParser::head_bytes() const {
  return state_->head_bytes;
}

void RequestParser::pop() {
  state_->begin();
}

}  // namespace talus::server::http
