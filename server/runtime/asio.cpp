// Asio's functions that are not templates, compiled once for the server (ASIO_SEPARATE_COMPILATION).
#include <asio/impl/src.hpp>
