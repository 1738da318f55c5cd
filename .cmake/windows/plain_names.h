// Before every source for Windows, whose headers define these names as macros.
#pragma once

#include <winsock2.h>

#undef far
#undef near
