// The input of a fuzzer as a file, since readers are given paths.
#pragma once

#include "acquisition/foundation/input_error.hpp"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <new>
#include <string>
#include <unistd.h>

namespace tapfit::fuzz {

/// A folder of this process in memory, where there is such a thing.
inline const std::filesystem::path& folder() {
  static const std::filesystem::path made = [] {
    const std::filesystem::path base =
        std::filesystem::is_directory("/dev/shm")
            ? "/dev/shm"
            : std::filesystem::temp_directory_path();
    const auto path = base / ("tapfit-fuzz-" + std::to_string(getpid()));
    std::filesystem::create_directories(path);
    std::atexit([] { std::filesystem::remove_all(folder()); });
    return path;
  }();
  return made;
}

/// Gives the bytes to a reader as a file. Anything that it throws but an
/// InputError with a remedy brings the fuzzer down, as a crash does.
inline int read_as(
    const char* name,
    const std::uint8_t* data,
    std::size_t size,
    const std::function<void(const std::filesystem::path&)>& read) {
  const std::filesystem::path file = folder() / name;
  std::ofstream(file, std::ios::binary)
      .write(reinterpret_cast<const char*>(data),
             static_cast<std::streamsize>(size));
  try {
    read(file);
  } catch (const InputError& error) {
    if (error.remedy().empty()) std::abort();
  }
  return 0;
}

}  // namespace tapfit::fuzz
