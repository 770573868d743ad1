#include "acquisition/foundation/cache_folder.hpp"

#include <cstdlib>
#include <string>

namespace tapfit::acquisition {

namespace fs = std::filesystem;

std::optional<fs::path> cache_folder() {
  const auto variable = [](const char* name) {
    const char* value = std::getenv(name);
    return std::string(value == nullptr ? "" : value);
  };
  const std::string off = variable("TAPFIT_NO_CACHE");
  if (!off.empty() && off != "0") return std::nullopt;
  // A relative path there is none (XDG Base Directory Specification).
  const fs::path cache = variable("XDG_CACHE_HOME");
  if (cache.is_absolute()) return cache / "tapfit";
  const fs::path home = variable("HOME");
  if (home.is_absolute()) return home / ".cache" / "tapfit";
  return std::nullopt;
}

}  // namespace tapfit::acquisition
