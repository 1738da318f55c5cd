#include "web/site.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include <talus/files/read_file.h>

#include "runtime/log/escape.h"
#include "web/accept_encoding.h"
#include "web/entity_tag.h"

namespace talus::server::web {
namespace {

namespace fs = std::filesystem;

// Best first.
constexpr std::array<std::pair<std::string_view, std::string_view>, 2> kCompressed{
    {{".br", "br"}, {".gz", "gzip"}}};

constexpr std::string_view kWasm = "application/wasm";

constexpr std::array<std::pair<std::string_view, std::string_view>, 21> kContentTypes{
    {{".css", "text/css; charset=utf-8"},
     {".gif", "image/gif"},
     {".glb", "model/gltf-binary"},
     {".html", "text/html; charset=utf-8"},
     {".ico", "image/x-icon"},
     {".jpg", "image/jpeg"},
     {".js", "text/javascript; charset=utf-8"},
     {".json", "application/json"},
     {".ktx2", "image/ktx2"},
     {".map", "application/json"},
     {".md", "text/markdown; charset=utf-8"},
     {".mjs", "text/javascript; charset=utf-8"},
     {".mp3", "audio/mpeg"},
     {".png", "image/png"},
     {".svg", "image/svg+xml"},
     {".txt", "text/plain; charset=utf-8"},
     {".wasm", kWasm},
     {".webmanifest", "application/manifest+json"},
     {".webp", "image/webp"},
     {".woff2", "font/woff2"},
     {".xml", "application/xml"}}};

std::string_view content_type_of(std::string_view name) {
  const std::size_t dot = name.rfind('.');
  const std::string_view ending = dot == std::string_view::npos ? std::string_view{} : name.substr(dot);
  const auto* const found = std::find_if(kContentTypes.begin(), kContentTypes.end(),
                                         [&](const auto& known) { return known.first == ending; });
  return found == kContentTypes.end() ? "application/octet-stream" : found->second;
}

bool is_lower(char c) {
  return c >= 'a' && c <= 'z';
}
bool is_upper_or_digit(char c) {
  return (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
}

/// Returns true if a URL needs no escapes for the name, so that a file has only one path.
bool is_plain(std::string_view name) {
  return std::all_of(name.begin(), name.end(), [](char c) {
    return is_lower(c) || is_upper_or_digit(c) || c == '.' || c == '_' || c == '-' || c == '~';
  });
}

/// Matches assets/NAME-HASH.js as bundlers write it: a hash of eight letters, digits, - and _. Eight
/// lower-case letters are taken for a word.
bool is_hashed(std::string_view path) {
  constexpr std::string_view kFolder{"assets/"};
  constexpr std::size_t kHash = 8;
  if (!path.starts_with(kFolder)) return false;
  std::string_view stem = path.substr(path.rfind('/') + 1);
  stem = stem.substr(0, stem.find('.'));
  if (stem.size() < kHash + 2 || stem[stem.size() - kHash - 1] != '-') return false;
  const std::string_view hash = stem.substr(stem.size() - kHash);
  return std::any_of(hash.begin(), hash.end(), is_upper_or_digit);
}

class Reader {
 public:
  Reader(fs::path directory, files::FileLayer& layer) : directory_{std::move(directory)}, layer_{layer} {}

  [[nodiscard]] std::optional<std::string> read() {
    std::error_code failed;
    root_ = fs::canonical(directory_, failed);
    if (failed) return fail(directory_, failed.message());
    if (auto wrong = read_folder(directory_, "", 0)) return wrong;
    if (!texts.contains("index.html")) return fail(directory_, "has no index.html");
    return std::nullopt;
  }

  std::map<std::string, std::string> texts;  // by path
  std::size_t bytes = 0;

 private:
  [[nodiscard]] static std::string fail(const fs::path& place, std::string_view why) {
    return fmt::format("{}: {}; give --web a directory of plain files with index.html, as the viewer's dist",
                       escaped(place.string(), 300), why);
  }

  [[nodiscard]] std::optional<std::string> read_folder(const fs::path& folder, const std::string& path,
                                                       int depth) {
    if (depth > Site::kMaxDepth) return fail(folder, fmt::format("is over {} folders deep", Site::kMaxDepth));
    std::error_code failed;
    fs::directory_iterator entries{folder, failed};
    if (failed) return fail(folder, failed.message());
    for (; entries != fs::directory_iterator{}; entries.increment(failed)) {
      const std::string name = entries->path().filename().string();
      if (name.starts_with('.')) continue;
      if (auto wrong = read_entry(entries->path(), path + name, name, depth)) return wrong;
    }
    return failed ? std::optional{fail(folder, failed.message())} : std::nullopt;
  }

  [[nodiscard]] std::optional<std::string> read_entry(const fs::path& place, const std::string& path,
                                                      const std::string& name, int depth) {
    if (!is_plain(name))
      return fail(place, "this name has other characters than letters, digits and . _ - ~");
    std::error_code failed;
    const fs::path real = fs::canonical(place, failed);
    if (failed) return fail(place, failed.message());
    if (std::mismatch(root_.begin(), root_.end(), real.begin(), real.end()).first != root_.end()) {
      return fail(place, "is a link that leads out of the directory");
    }
    if (fs::is_directory(real, failed)) return read_folder(place, path + '/', depth + 1);
    if (texts.size() == Site::kMaxFiles) {
      return fail(directory_, fmt::format("has over {} files", Site::kMaxFiles));
    }
    auto text = files::read_regular_file(real, Site::kMaxBytes - bytes, layer_);
    if (!text && text.error().code == std::errc::file_too_large) {
      return fail(directory_, fmt::format("has over {} MiB", Site::kMaxBytes >> 20));
    }
    if (!text) return fail(place, text.error().reason);
    bytes += text->size();
    texts.emplace(path, *std::move(text));
    return std::nullopt;
  }

  const fs::path directory_;
  files::FileLayer& layer_;
  fs::path root_;
};

}  // namespace

tl::expected<std::shared_ptr<const Site>, std::string> Site::read(const std::filesystem::path& directory,
                                                                  files::FileLayer& layer) {
  Reader reader{directory, layer};
  if (auto wrong = reader.read()) return tl::make_unexpected(*std::move(wrong));
  auto site = std::make_shared<Site>();
  site->bytes_ = reader.bytes;
  const auto form = [](std::string_view encoding, std::string text) {
    const http::EntityTag etag = entity_tag(text);
    return Form{encoding, std::move(text), etag};
  };
  std::map<std::string, std::string>& texts = reader.texts;
  // In the order of names a compressed form follows its file; it is removed from there.
  for (auto each = texts.begin(); each != texts.end(); ++each) {
    File file{content_type_of(each->first), is_hashed(each->first), {}};
    for (const auto& [ending, encoding] : kCompressed) {
      auto compressed = texts.extract(each->first + std::string{ending});
      if (!compressed.empty()) file.forms.push_back(form(encoding, std::move(compressed.mapped())));
    }
    file.forms.push_back(form({}, std::move(each->second)));
    if (file.content_type == kWasm) site->has_wasm_ = true;
    site->files_.emplace(each->first, std::move(file));
  }
  return site;
}

const Site::File* Site::find(std::string_view path) const {
  if (!path.starts_with('/')) return nullptr;
  path.remove_prefix(1);
  const bool folder = path.empty() || path.ends_with('/');
  const auto found = folder ? files_.find(std::string{path} + "index.html") : files_.find(path);
  return found == files_.end() ? nullptr : &found->second;
}

const Site::Form& Site::File::form_for(std::string_view accept_encoding) const {
  const auto taken = std::find_if(forms.begin(), forms.end() - 1, [&](const Form& form) {
    return accepts_encoding(accept_encoding, form.encoding);
  });
  return *taken;
}

}  // namespace talus::server::web
