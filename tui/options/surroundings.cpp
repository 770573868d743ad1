#include "tui/options/surroundings.hpp"

#include "acquisition/foundation/cache_folder.hpp"
#include "tui/screen/terminal.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <system_error>
#include <thread>
#include <unistd.h>

namespace tapfit::tui {
namespace {

namespace fs = std::filesystem;

std::string variable(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

std::string locale_name() {
  for (const char* name : {"LC_ALL", "LC_CTYPE", "LANG"}) {
    if (const std::string value = variable(name); !value.empty()) return value;
  }
  return "C";
}

std::uintmax_t bytes_in(const fs::path& folder) {
  std::uintmax_t bytes = 0;
  std::error_code fault;
  for (fs::directory_iterator at(folder, fault), end; !fault && at != end;
       at.increment(fault)) {
    std::error_code gone;
    const std::uintmax_t size = at->file_size(gone);
    if (!gone) bytes += size;
  }
  return bytes;
}

/// Whether files can be made in it, or it can be made.
bool is_writable(fs::path folder) {
  std::error_code fault;
  while (!fs::exists(folder, fault) && folder.has_relative_path()) {
    folder = folder.parent_path();
  }
  return access(folder.c_str(), W_OK) == 0;
}

/// A line such as "MemTotal:  16303020 kB"; 0 where there is none.
double meminfo_bytes(const std::string& name) {
  std::ifstream file("/proc/meminfo");
  for (std::string line; std::getline(file, line);) {
    if (!line.starts_with(name + ":")) continue;
    return 1024.0 * std::strtod(line.c_str() + name.size() + 1, nullptr);
  }
  return 0.0;
}

/// What a container or a service may have at most; 0 where that is not said.
double granted_bytes() {
  std::ifstream file("/sys/fs/cgroup/memory.max");
  double bytes = 0.0;
  return file >> bytes ? bytes : 0.0;
}

}  // namespace

Surroundings look_around() {
  Surroundings found;
  found.terminal = look_at_terminal();
  found.no_colour = !variable("NO_COLOR").empty();
  found.in_tmux = !variable("TMUX").empty();
  found.utf8 = locale_is_utf8();
  found.locale = locale_name();
  found.cache = acquisition::cache_folder();
  if (found.cache) {
    found.cache_writable = is_writable(*found.cache);
    found.cache_bytes = bytes_in(*found.cache);
  }
  found.memory_bytes = meminfo_bytes("MemTotal");
  found.free_bytes = meminfo_bytes("MemAvailable");
  if (const double granted = granted_bytes(); granted > 0.0) {
    found.memory_bytes = std::min(found.memory_bytes, granted);
    found.free_bytes = std::min(found.free_bytes, granted);
  }
  found.threads = std::max(1U, std::thread::hardware_concurrency());
  found.omp_threads = variable("OMP_NUM_THREADS");
  return found;
}

}  // namespace tapfit::tui
