#include <talus_local.h>

const char* talus_status_name(talus_status status) {
  switch (status) {
    case TALUS_OK:
      return "TALUS_OK";
    case TALUS_NO_EVENT:
      return "TALUS_NO_EVENT";
    case TALUS_INVALID_ARGUMENT:
      return "TALUS_INVALID_ARGUMENT";
    case TALUS_OUT_OF_MEMORY:
      return "TALUS_OUT_OF_MEMORY";
    case TALUS_INTERNAL:
      return "TALUS_INTERNAL";
    case TALUS_UNSUPPORTED:
      return "TALUS_UNSUPPORTED";
    case TALUS_ALREADY_CONNECTED:
      return "TALUS_ALREADY_CONNECTED";
    case TALUS_TOO_MANY_EVENTS:
      return "TALUS_TOO_MANY_EVENTS";
    case TALUS_UNREACHABLE:
      return "TALUS_UNREACHABLE";
    case TALUS_REFUSED:
      return "TALUS_REFUSED";
    case TALUS_UNTRUSTED:
      return "TALUS_UNTRUSTED";
    case TALUS_DISCONNECTED:
      return "TALUS_DISCONNECTED";
    case TALUS_TIMED_OUT:
      return "TALUS_TIMED_OUT";
    case TALUS_WORLD_CHANGED:
      return "TALUS_WORLD_CHANGED";
    case TALUS_BROKEN_PROTOCOL:
      return "TALUS_BROKEN_PROTOCOL";
    case TALUS_BAD_CHUNK:
      return "TALUS_BAD_CHUNK";
    case TALUS_OUT_OF_RANGE:
      return "TALUS_OUT_OF_RANGE";
    case TALUS_OVERLOADED:
      return "TALUS_OVERLOADED";
    case TALUS_CANCELLED:
      return "TALUS_CANCELLED";
    case TALUS_SERVER_FAILED:
      return "TALUS_SERVER_FAILED";
    case TALUS_NOT_CONNECTED:
      return "TALUS_NOT_CONNECTED";
    case TALUS_CONFLICT:
      return "TALUS_CONFLICT";
    case TALUS_NOT_APPLIED:
      return "TALUS_NOT_APPLIED";
    case TALUS_OUTCOME_UNKNOWN:
      return "TALUS_OUTCOME_UNKNOWN";
    case TALUS_CANNOT_GENERATE:
      return "TALUS_CANNOT_GENERATE";
    case TALUS_BAD_WORLD:
      return "TALUS_BAD_WORLD";
    case TALUS_FILE_FAILED:
      return "TALUS_FILE_FAILED";
    case TALUS_FILE_IN_USE:
      return "TALUS_FILE_IN_USE";
    case TALUS_BAD_SAVE:
      return "TALUS_BAD_SAVE";
    case TALUS_OTHER_SAVE:
      return "TALUS_OTHER_SAVE";
    default:
      return "unknown status";
  }
}
