#include <talus/tools/option_values.h>

#include <charconv>
#include <cstdint>
#include <string>
#include <system_error>

namespace talus::tools {
namespace {

std::string quoted(std::string_view text) {
  return "'" + std::string{text} + "'";
}

Expected<std::int64_t> parse_integer(std::string_view option, std::string_view text, std::string_view whole) {
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc::result_out_of_range) {
    return wrong_use(std::string{option} + ": " + std::string{text} + " does not fit 64 bits");
  }
  if (error != std::errc{} || end != text.data() + text.size()) {
    return wrong_use(std::string{option} + ": " + quoted(whole) +
                     " is not a pair of whole numbers; write it like " + std::string{option} + " 640,-32");
  }
  return value;
}

// A region may start and end anywhere that chunks of its level can.
Expected<terrain::Region> checked(std::string_view option, IntegerPair first, IntegerPair size, Lod lod) {
  const std::int64_t limit = chunk_limit(lod) * kChunkSize;
  const auto check_axis = [&](const char* axis, std::int64_t from, std::int64_t length) -> Expected<void> {
    const std::int64_t last = from + length - 1;
    if (from >= -limit && last < limit) return {};
    const std::int64_t culprit = from < -limit ? from : last;
    return wrong_use(std::string{option} + ": column " + axis + " = " + std::to_string(culprit) +
                     " lies outside the world, which has columns " + std::to_string(-limit) + " to " +
                     std::to_string(limit - 1) + " at level of detail " + std::to_string(lod.value()));
  };
  if (auto x = check_axis("x", first.first, size.first); !x) return tl::make_unexpected(x.error());
  if (auto z = check_axis("z", first.second, size.second); !z) return tl::make_unexpected(z.error());
  return terrain::Region{first.first, first.second, static_cast<int>(size.first),
                         static_cast<int>(size.second), lod};
}

// Checked before any arithmetic, which could overflow.
Expected<void> check_base(std::string_view option, IntegerPair base) {
  const std::int64_t limit = chunk_limit(Lod{}) * kChunkSize;
  const auto check_axis = [&](const char* axis, std::int64_t value) -> Expected<void> {
    if (value >= -limit && value < limit) return {};
    return wrong_use(std::string{option} + ": " + axis + " = " + std::to_string(value) +
                     " lies outside the world, which reaches from " + std::to_string(-limit) + " to " +
                     std::to_string(limit - 1));
  };
  if (auto x = check_axis("x", base.first); !x) return x;
  return check_axis("z", base.second);
}

IntegerPair at_level(IntegerPair base, Lod lod) {
  return {floor_div(base.first, std::int64_t{1} << lod.value()),
          floor_div(base.second, std::int64_t{1} << lod.value())};
}

}  // namespace

Expected<IntegerPair> parse_pair(std::string_view option, std::string_view text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string_view::npos) return tl::make_unexpected(parse_integer(option, "", text).error());
  const auto first = parse_integer(option, text.substr(0, comma), text);
  if (!first) return tl::make_unexpected(first.error());
  const auto second = parse_integer(option, text.substr(comma + 1), text);
  if (!second) return tl::make_unexpected(second.error());
  return IntegerPair{*first, *second};
}

Expected<IntegerPair> parse_size(std::string_view option, std::string_view text, std::int64_t longest) {
  auto size = parse_pair(option, text);
  if (!size) return size;
  for (const std::int64_t side : {size->first, size->second}) {
    if (side >= 1 && side <= longest) continue;
    return wrong_use(std::string{option} + ": " + std::to_string(side) + " is not a length from 1 to " +
                     std::to_string(longest));
  }
  return size;
}

Expected<Lod> parse_lod(std::int64_t level) {
  const auto lod = Lod::checked(level);
  if (!lod) return wrong_use("--lod: " + lod.error().message);
  return *lod;
}

Expected<terrain::Region> region_from_origin(std::string_view option, IntegerPair base, IntegerPair size,
                                             Lod lod) {
  if (auto in_world = check_base(option, base); !in_world) return tl::make_unexpected(in_world.error());
  return checked(option, at_level(base, lod), size, lod);
}

Expected<terrain::Region> region_around(std::string_view option, IntegerPair base, IntegerPair size,
                                        Lod lod) {
  if (auto in_world = check_base(option, base); !in_world) return tl::make_unexpected(in_world.error());
  const IntegerPair centre = at_level(base, lod);
  return checked(option, {centre.first - size.first / 2, centre.second - size.second / 2}, size, lod);
}

}  // namespace talus::tools
