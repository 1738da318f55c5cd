// Before every source for Windows, whose headers make nothing of these names.
#pragma once

#include <winsock2.h>

#undef far
#undef near
