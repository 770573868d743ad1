// tapfit doctor: whether the program has what it needs where it runs, what that
// means, and what to do where it has not.
#pragma once

#include "tui/app/settings.hpp"
#include "tui/options/surroundings.hpp"

#include <string>
#include <vector>

namespace tapfit::tui {

/// One thing that was looked at.
struct HealthCheck {
  std::string name;     ///< "colours"
  std::string found;    ///< "8"
  std::string meaning;  ///< what that does to the work
  std::string advice;   ///< what to do; empty where all is well
};

[[nodiscard]] std::vector<HealthCheck> health_checks(const Surroundings& here,
                                                     const Settings& settings);

}  // namespace tapfit::tui
