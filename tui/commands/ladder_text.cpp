#include "tui/commands/ladder_text.hpp"

#include "tui/commands/effect_output.hpp"
#include "tui/commands/text_table.hpp"

#include <algorithm>
#include <cmath>

namespace tapfit::tui {

namespace {

constexpr double bar_length = 30.0;

std::string bar(double error, double longest) {
  if (longest <= 0.0) return {};
  const double length = std::round(bar_length * error / longest);
  return std::string(static_cast<std::size_t>(std::max(length, 1.0)), '#');
}

}  // namespace

std::string ladder_text(double base,
                        const std::vector<updating::Rung>& rungs,
                        double floor) {
  double longest = std::max(base, floor);
  for (const auto& rung : rungs) longest = std::max(longest, rung.error);

  TextTable table({"<error ladder", "error", "<"});
  table.add({"base model", percent(base), bar(base, longest)});
  for (const auto& rung : rungs) {
    table.add({"+ " + effect_text(rung.added, rung.where),
               percent(rung.error),
               bar(rung.error, longest)});
  }
  table.add({"floor", percent(floor), bar(floor, longest)});
  return table.text();
}

}  // namespace tapfit::tui
