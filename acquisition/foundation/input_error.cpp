#include "acquisition/foundation/input_error.hpp"

#include "acquisition/foundation/utf8.hpp"

#include <fmt/format.h>

#include <utility>

namespace tapfit {

// What is quoted of the input may hold any bytes.
InputError::InputError(const std::string& what,
                       std::string where,
                       std::string remedy)
    : std::runtime_error(acquisition::printable(
          fmt::format("{}: {} ({})", where, what, remedy))),
      fault_(acquisition::printable(what)),
      where_(std::move(where)),
      remedy_(std::move(remedy)) {}

}  // namespace tapfit
