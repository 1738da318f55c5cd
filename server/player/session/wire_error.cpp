#include "player/session/wire_error.h"

#include "player/session/retry_after.h"

namespace talus::server {

WireError wire_error(EditErrorCode code) {
  using Code = EditErrorCode;
  using Wire = wire::ErrorCode;
  switch (code) {
    case Code::out_of_range:
    case Code::index_full:
      return {Wire::out_of_range, retry_after::kNever};
    case Code::too_large:
      return {Wire::too_large, retry_after::kNever};
    case Code::malformed:
      return {Wire::malformed, retry_after::kNever};
    case Code::forbidden:
      return {Wire::forbidden, retry_after::kNever};
    case Code::unsupported:
      return {Wire::unsupported, retry_after::kNever};
    case Code::conflict:
      return {Wire::conflict, retry_after::kNever};
    case Code::not_applied:
      return {Wire::not_applied, retry_after::kNever};
    case Code::expired:
      return {Wire::expired, retry_after::kNever};
    case Code::invalid:
      return {Wire::internal, retry_after::kNever};
    case Code::ground:
    case Code::unreadable:
      return {Wire::internal, retry_after::kFailed};
    case Code::too_many_unanswered:
      return {Wire::too_many_requests, retry_after::kBusy};
    case Code::leaving:
      return {Wire::overloaded, retry_after::kLeaving};
    case Code::cut_off:
      return {Wire::overloaded, retry_after::kCutOff};
    case Code::editors_full:
      return {Wire::overloaded, retry_after::kEditorsFull};
    default:
      return {Wire::overloaded, retry_after::kBusy};
  }
}

std::string_view client_text(const EditError& error) {
  using Code = EditErrorCode;
  switch (error.code) {
    case Code::unwritable:
      return "the server's store cannot be written now; send the edit again later";
    case Code::unreadable:
      return "the server's store cannot read a chunk of the edit";
    case Code::cut_off:
      return "the log that this world's servers share cannot be reached now; send the edit again later";
    default:
      return error.message;
  }
}

}  // namespace talus::server
