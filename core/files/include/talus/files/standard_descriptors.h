// Standard input, output and error of a program that was started without them.
#pragma once

namespace talus::files {

/// Opens /dev/null in the place of each of the descriptors 0, 1 and 2 that is closed. Else the next file or
/// socket that is opened takes its number, and lines for standard error land in that. Nothing can be read
/// from such an input, such an output still takes no result, so that a command says that it got none, and
/// such an error output takes all. First in main(), while no other thread runs. Without a /dev/null they stay
/// closed.
void open_closed_standard_descriptors();

}  // namespace talus::files
