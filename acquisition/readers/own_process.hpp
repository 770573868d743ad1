// Work that a process of its own does, because a library that is given a
// damaged file may come down with it or walk in circles (HDF5 1.10 does both).
// The program itself goes on and says what is wrong.
#pragma once

#include <cstdio>
#include <filesystem>
#include <functional>
#include <stop_token>

namespace tapfit::acquisition {

/// Runs `write` in a process of its own and `read` in this one on what it
/// writes.
///
/// @param file what is read, for messages; its size bounds the computing time
/// @param write may throw InputError, which is thrown here
/// @param read gets the bytes; must bear their end at any place
/// @param stop ends the process, wherever it is
/// @throws InputError also where the process came down or took too long;
///   Stopped
void in_own_process(const std::filesystem::path& file,
                    const std::function<void(std::FILE*)>& write,
                    const std::function<void(std::FILE*)>& read,
                    const std::stop_token& stop = {});

}  // namespace tapfit::acquisition
