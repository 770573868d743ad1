#include "updating/session/saved_fields.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace tapfit::updating::saved {

using json = nlohmann::ordered_json;

int index_from(const json& value, const char* counted) {
  if (value.is_number_integer()) {
    const auto number = value.get<long long>();
    constexpr int most = std::numeric_limits<int>::max();
    if (number >= 1 && number <= most) return static_cast<int>(number - 1);
  }
  throw std::out_of_range(
      fmt::format("{} are counted from 1, in whole numbers", counted));
}

void check_fields(const json& value,
                  const char* what,
                  std::initializer_list<const char*> known) {
  if (!value.is_object()) {
    throw std::out_of_range(fmt::format("{} is not in braces", what));
  }
  for (const auto& [name, ignored] : value.items()) {
    const bool is_known = std::ranges::any_of(
        known, [&name = name](const char* field) { return name == field; });
    if (!is_known) {
      throw std::out_of_range(fmt::format("{} has no field \"{}\", only {}",
                                          what,
                                          name,
                                          fmt::join(known, ", ")));
    }
  }
}

const json& list_in(const json& value, const char* name) {
  static const json none = json::array();
  if (!value.contains(name)) return none;
  const json& list = value.at(name);
  if (list.is_array()) return list;
  throw std::out_of_range(fmt::format("\"{}\" is no list in brackets", name));
}

}  // namespace tapfit::updating::saved
