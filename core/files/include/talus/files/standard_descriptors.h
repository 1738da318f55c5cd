// Handles standard descriptors that were closed at start.
#pragma once

namespace talus::files {

/// Opens /dev/null for each of the descriptors 0, 1 and 2 that is closed; otherwise the next file or socket
/// would take the number, and standard error would be written into it. The input is empty, the output still
/// fails on writing, so that a command reports that its result is lost, and the error output accepts
/// everything. Call first in main(), while no other thread runs. Without /dev/null the descriptors stay
/// closed. On Windows, output also keeps its line ends, and the console shows it as UTF-8.
void open_closed_standard_descriptors();

}  // namespace talus::files
