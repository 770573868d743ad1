#pragma once

namespace tapfit {

/// Keeps freed memory of the process for what is asked for next, up to 256 MB,
/// instead of giving it back to the system. Large arrays come and go thousands
/// of times in an identification, and the system clears every page anew: half
/// of its time. For the start of a program; does nothing without glibc.
void reuse_memory();

}  // namespace tapfit
