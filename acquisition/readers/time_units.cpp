#include "acquisition/readers/time_units.hpp"

#include <algorithm>
#include <array>

namespace tapfit::acquisition {

std::optional<double> seconds_in(std::string_view unit) {
  struct Unit {
    std::string_view text;
    double seconds;
  };
  constexpr auto units = std::to_array<Unit>({{"s", 1.0},
                                              {"sec", 1.0},
                                              {"seconds", 1.0},
                                              {"ms", 1e-3},
                                              {"msec", 1e-3},
                                              {"milliseconds", 1e-3},
                                              {"us", 1e-6},
                                              {"usec", 1e-6},
                                              {"\xc2\xb5s", 1e-6},
                                              {"\xce\xbcs", 1e-6},
                                              {"microseconds", 1e-6},
                                              {"ns", 1e-9},
                                              {"nanoseconds", 1e-9}});
  const auto found = std::ranges::find(units, unit, &Unit::text);
  if (found == units.end()) return std::nullopt;
  return found->seconds;
}

}  // namespace tapfit::acquisition
