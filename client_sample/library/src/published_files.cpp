#include "published_files.h"

#include "printable_line.h"

namespace talus::client {

std::string PublishedFiles::begin(const std::string& name) {
  name_ = name;
  bytes_.clear();
  size_ = 0;
  if (name.size() > kMaxNameBytes) {
    return "the world names a file by " + std::to_string(name.size()) + " bytes; at most " +
           std::to_string(kMaxNameBytes) + " are allowed";
  }
  if (files_->contains(name)) return "the world cannot be read with its file " + printable_line(name, 100);
  if (files_->size() >= kMaxFiles) return "the world names more than " + std::to_string(kMaxFiles) + " files";
  return {};
}

tl::expected<bool, std::string> PublishedFiles::take(const FileRequest::Part& part) {
  const std::string which = name_.empty() ? "the world's file" : "file " + printable_line(name_, 100);
  const std::uint64_t limit = name_.empty() ? kMaxWorldFileBytes : kMaxBytes - total_;
  if (part.size > limit) {
    return tl::unexpected{which + " has " + std::to_string(part.size) + " bytes; at most " +
                          std::to_string(limit) + " are fetched"};
  }
  if (!bytes_.empty() && part.size != size_) return tl::unexpected{which + " changed while it was fetched"};
  size_ = part.size;
  bytes_.insert(bytes_.end(), part.bytes.begin(), part.bytes.end());
  if (bytes_.size() < size_) return false;
  total_ += bytes_.size();
  auto files = std::make_shared<WorldFiles>(*files_);
  files->emplace(name_, std::make_shared<const std::vector<std::byte>>(std::move(bytes_)));
  bytes_ = {};
  files_ = std::move(files);
  return true;
}

}  // namespace talus::client
