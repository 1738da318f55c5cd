// The version that programs print for --version. Only a program's main.cpp includes this: its library and its
// tests are then not linked anew at each commit.
#pragma once

namespace talus {

/// "0.2.0 (c6ced027)": the release and the first eight digits of the commit; "0.2.0" if the commit is
/// unknown.
extern const char* const kBuildVersion;

}  // namespace talus
