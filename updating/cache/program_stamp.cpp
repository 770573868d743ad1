#include "updating/cache/program_stamp.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <system_error>

namespace tapfit::updating {

std::optional<std::string> program_stamp() {
  const std::filesystem::path self = "/proc/self/exe";
  std::error_code fault;
  const auto bytes = std::filesystem::file_size(self, fault);
  if (fault) return std::nullopt;
  const auto written = std::filesystem::last_write_time(self, fault);
  if (fault) return std::nullopt;
  return fmt::format("{} {}", bytes, written.time_since_epoch().count());
}

}  // namespace tapfit::updating
