#include "acquisition/input_error.hpp"

#include <fmt/format.h>

#include <utility>

namespace tapfit {

InputError::InputError(const std::string& what,
                       std::string where,
                       std::string remedy)
    : std::runtime_error(fmt::format("{}: {} ({})", where, what, remedy)),
      where_(std::move(where)),
      remedy_(std::move(remedy)) {}

}  // namespace tapfit
