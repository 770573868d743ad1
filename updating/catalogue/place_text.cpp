#include "updating/catalogue/place_text.hpp"

#include "acquisition/foundation/dof.hpp"
#include "acquisition/foundation/input_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace tapfit::updating {

std::vector<std::string> parts_of(const std::string& text) {
  std::vector<std::string> parts;
  std::size_t begin = 0;
  while (begin <= text.size()) {
    const std::size_t end =
        std::min(text.find_first_of(":,", begin), text.size());
    parts.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

std::vector<int> numbers_in(const std::string& text) {
  std::vector<int> numbers;
  for (const std::string& part : parts_of(text)) {
    const bool digits =
        !part.empty() && part.size() < 10 &&
        std::all_of(part.begin(), part.end(), [](unsigned char c) {
          return std::isdigit(c) != 0;
        });
    if (!digits) return {};
    numbers.push_back(std::stoi(part));
  }
  return numbers;
}

bool is_grid(const std::string& part) { return !numbers_in(part).empty(); }

int test_point_in(const std::string& text) {
  if (!text.starts_with('P')) return 0;
  const std::vector<int> numbers = numbers_in(text.substr(1));
  return numbers.size() == 1 ? numbers.front() : 0;
}

Location on_the_mesh(const EffectRef& ref, const effects::TestContext& s) {
  Location where = ref.where;
  if (where.node >= 0 || s.deck == nullptr) return where;
  const auto point = std::ranges::find(
      s.deck->measuring, where.node, &structure::MeasuringPoint::grid);
  if (point == s.deck->measuring.end()) {
    throw InputError(
        fmt::format("the test has no point {}", node_name(where.node)),
        fmt::format("effect \"{}@{}\"", ref.effect, node_name(where.node)),
        "name a point that something is hit or measured at, or a grid");
  }
  constexpr double at_a_grid_m = 1e-6;
  where.node = point->nearest;
  if (point->to_grid > at_a_grid_m) {
    where.at = {point->foot.x(), point->foot.y(), point->foot.z()};
  }
  return where;
}

}  // namespace tapfit::updating
