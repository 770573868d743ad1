#include "tui/report/mode_remarks.hpp"

#include "tui/screen/number.hpp"
#include "tui/widgets/bars.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tapfit::tui {
namespace {

using updating::ModePair;

constexpr double least_mac = 0.9;      // pairs above it look alike
constexpr double most_percent = 1.0;   // of a frequency's error
constexpr double close_percent = 1.0;  // apart, as far as shapes mix

bool is_off(const ModePair& pair) {
  return (pair.has_shape && pair.mac < least_mac) ||
         std::abs(pair.error_percent) > most_percent;
}

/// The pair whose measured mode is nearest; none where it is the only one.
const ModePair* nearest(const std::vector<ModePair>& pairs,
                        const ModePair& pair) {
  const ModePair* found = nullptr;
  for (const ModePair& other : pairs) {
    if (other.measured == pair.measured) continue;
    const double away = std::abs(other.measured_hz - pair.measured_hz);
    if (found == nullptr ||
        away < std::abs(found->measured_hz - pair.measured_hz)) {
      found = &other;
    }
  }
  return found;
}

}  // namespace

std::vector<std::string> mode_remarks(const updating::Comparison& c) {
  if (!(c.error <= near_floor * c.floor)) return {};
  std::vector<std::string> remarks;
  std::string others;
  for (const ModePair& pair : c.pairs) {
    if (!is_off(pair)) continue;
    const ModePair* beside = nearest(c.pairs, pair);
    const double apart =
        beside == nullptr
            ? 100.0
            : 100.0 * std::abs(beside->measured_hz / pair.measured_hz - 1.0);
    if (apart > close_percent) {
      others += fmt::format(
          "{}{} Hz", others.empty() ? "" : ", ", number(pair.measured_hz));
    } else if (beside->measured_hz > pair.measured_hz || !is_off(*beside)) {
      remarks.push_back(fmt::format(
          "{} and {} Hz are {} % apart: their shapes mix, and neither MAC nor "
          "the order of the two says much",
          number(pair.measured_hz),
          number(beside->measured_hz),
          fixed(apart, 2)));
    }
  }
  if (!others.empty()) {
    remarks.push_back(fmt::format(
        "off though the FRFs agree as well as the measurement supports: {}. "
        "The error is taken with added damping, which a single sharp resonance "
        "changes little; 4 "
        "shows the curves",
        others));
  }
  return remarks;
}

}  // namespace tapfit::tui
