#pragma once

namespace shapegauge {

/// From now on the first Ctrl-C (SIGINT) does not end the program but is remembered; a second one ends it.
void catch_interruption();

/// Whether there was one.
bool interrupted();

}  // namespace shapegauge
