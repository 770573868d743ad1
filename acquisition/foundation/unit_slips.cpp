#include "acquisition/foundation/unit_slips.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <vector>

namespace tapfit::acquisition {
namespace {

constexpr double as_known = 1.05;

constexpr std::array<UnitSlip, 5> basic{{
    {"1000", 1000.0, "kN for N, mm for m, or mV for V"},
    {"9.807", 9.80665, "g for m/s^2, or kgf for N"},
    {"4.448", 4.4482216, "lbf for N"},
    {"386.1", 386.0886, "g for in/s^2"},
    {"25.4", 25.4, "in for mm"},
}};

constexpr std::array<UnitSlip, 2> composed{{
    {"39.37", 1000.0 / 25.4, "in for m"},
    {"9807", 9806.65, "g for mm/s^2"},
}};

constexpr std::array<UnitSlip, 3> ranges{{
    {"10", 10.0, "a range switched by 20 dB"},
    {"100", 100.0, "a range switched by 40 dB"},
    {"3.162", 3.1622776601683795, "a range switched by 10 dB"},
}};

constexpr std::array<UnitSlip, 5> masses{{
    {"1000", 1000.0, "g or t for kg"},
    {"2.205", 2.20462262, "lb for kg"},
    {"9.807", 9.80665, "a weight in N for kg, or a weight density"},
    {"386.1", 386.0886, "a weight density in inches"},
    {"175.1", 175.126835, "lbf s^2/in for kg"},
}};

std::string listed(std::initializer_list<std::span<const UnitSlip>> lists,
                   double least,
                   double most) {
  std::vector<UnitSlip> found;
  for (const auto& list : lists) {
    for (const UnitSlip& slip : list) {
      const double back = 1.0 / slip.factor;
      if ((slip.factor >= least && slip.factor <= most) ||
          (back >= least && back <= most)) {
        found.push_back(slip);
      }
    }
  }
  const double middle = 0.5 * std::abs(std::log(least * most));
  std::ranges::sort(found, {}, [middle](const UnitSlip& slip) {
    return std::abs(std::log(slip.factor) - middle);
  });
  std::string words;
  for (const UnitSlip& slip : found) {
    words += fmt::format(
        "{}{}: {}", words.empty() ? "" : "; ", slip.name, slip.words);
  }
  return words;
}

}  // namespace

std::span<const UnitSlip> unit_slips() { return basic; }
std::span<const UnitSlip> composed_unit_slips() { return composed; }
std::span<const UnitSlip> range_steps() { return ranges; }
std::span<const UnitSlip> mass_slips() { return masses; }

std::string units_between(double least, double most) {
  return listed({basic, composed}, least, most);
}

std::string channel_slip(double factor) {
  return listed(
      {basic, composed, ranges}, factor / as_known, factor * as_known);
}

std::string mass_slip(double factor) {
  return listed({masses}, factor / as_known, factor * as_known);
}

}  // namespace tapfit::acquisition
