#include "tui/report/ladder_text.hpp"

#include "tui/report/effect_output.hpp"
#include "tui/report/text_table.hpp"

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

std::string ladder_text(const updating::Diagnosis& d) {
  double longest = std::max(d.error_base, d.floor);
  for (const auto& rung : d.ladder) longest = std::max(longest, rung.error);

  TextTable table({"<error ladder", "error", "<"});
  const auto add = [&](const std::string& name, double error) {
    table.add({name, percent(error), bar(error, longest)});
  };
  add("base model", d.error_base);
  const bool any = !d.model_parameters.empty();
  if (any) add("uncertain properties fitted", d.error_fitted);
  for (const auto& rung : d.ladder) {
    add("+ " + effect_text(rung.added, rung.where), rung.error);
  }
  add("floor", d.floor);
  return table.text();
}

}  // namespace tapfit::tui
