#include <talus/files/npy_header.h>

#include <algorithm>
#include <cstring>
#include <optional>
#include <string_view>
#include <utility>

namespace talus::files {
namespace {

constexpr std::string_view kMagic{"\x93NUMPY"};
constexpr std::string_view kMalformed =
    "is an .npy whose header is not {'descr': TYPE, 'fortran_order': False or True, 'shape': (LENGTH, ...)}";

/// Reads the literals of Python that a header consists of.
class HeaderText {
 public:
  explicit HeaderText(std::string_view text) : text_{text} {}

  [[nodiscard]] bool take(std::string_view token) {
    text_.remove_prefix(std::min(text_.find_first_not_of(" \t\r\n\f"), text_.size()));
    if (!text_.starts_with(token)) return false;
    text_.remove_prefix(token.size());
    return true;
  }

  [[nodiscard]] std::optional<std::string> string() {
    const std::string_view quote = take("'") ? "'" : "\"";
    if (quote == "\"" && !take(quote)) return std::nullopt;
    const std::size_t length = text_.find(quote);
    if (length == std::string_view::npos) return std::nullopt;
    std::string value{text_.substr(0, length)};
    text_.remove_prefix(length + 1);
    return value;
  }

  [[nodiscard]] std::optional<bool> boolean() {
    if (take("True")) return true;
    return take("False") ? std::optional{false} : std::nullopt;
  }

  [[nodiscard]] std::optional<std::vector<std::uint64_t>> tuple() {
    if (!take("(")) return std::nullopt;
    std::vector<std::uint64_t> numbers;
    while (!take(")")) {
      const auto next = number();
      if (!next || numbers.size() == kMaxAxes) return std::nullopt;
      numbers.push_back(*next);
      if (take(",")) continue;
      return take(")") && numbers.size() > 1 ? std::optional{numbers} : std::nullopt;
    }
    return numbers;
  }

 private:
  static constexpr std::size_t kMaxAxes = 64;  // NumPy's own bound
  static constexpr std::size_t kMaxDigits = 18;

  std::optional<std::uint64_t> number() {
    (void)take("");
    std::uint64_t value = 0;
    std::size_t digits = 0;
    for (; digits < text_.size() && text_[digits] >= '0' && text_[digits] <= '9'; ++digits) {
      if (digits == kMaxDigits) return std::nullopt;
      value = value * 10 + static_cast<std::uint64_t>(text_[digits] - '0');
    }
    text_.remove_prefix(digits);
    (void)take("L");  // Python 2's long integers
    return digits == 0 ? std::nullopt : std::optional{value};
  }

  std::string_view text_;
};

}  // namespace

bool is_npy(std::span<const std::byte> file) {
  return file.size() >= kMagic.size() && std::memcmp(file.data(), kMagic.data(), kMagic.size()) == 0;
}

tl::expected<NpyHeader, std::string> read_npy_header(std::span<const std::byte> file) {
  const auto refused = [](std::string what) { return tl::unexpected{std::move(what)}; };
  const auto byte = [&](std::size_t i) { return std::to_integer<std::size_t>(file[i]); };
  if (file.size() < 12) return refused("is an .npy that ends in its header");
  const std::size_t version = byte(6);
  if (version < 1 || version > 3) {
    return refused("is an .npy of version " + std::to_string(version) + "; 1 to 3 are known");
  }
  const std::size_t start = version == 1 ? 10 : 12;
  std::size_t length = byte(8) | byte(9) << 8;
  if (version > 1) length |= byte(10) << 16 | byte(11) << 24;
  if (length > file.size() - start) return refused("is an .npy that ends in its header");

  HeaderText text{{reinterpret_cast<const char*>(file.data()) + start, length}};
  std::optional<std::string> type;
  std::optional<bool> fortran_order;
  std::optional<std::vector<std::uint64_t>> shape;
  bool more = text.take("{");
  while (more && !text.take("}")) {
    const auto key = text.string();
    if (!key || !text.take(":")) return refused(std::string{kMalformed});
    if (*key == "descr" && text.take("[")) {
      return refused("is an .npy of records; an array of numbers is needed");
    }
    if (*key == "descr") type = text.string();
    if (*key == "fortran_order") fortran_order = text.boolean();
    if (*key == "shape") shape = text.tuple();
    more = text.take(",");
    if (!more && !text.take("}")) return refused(std::string{kMalformed});
  }
  if (!type || !fortran_order || !shape) return refused(std::string{kMalformed});
  return NpyHeader{*std::move(type), *fortran_order, *std::move(shape), start + length};
}

}  // namespace talus::files
