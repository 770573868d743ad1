#include "tui/widgets/ticks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tapfit::tui {
namespace {

std::string label(double value, double step) {
  if (std::abs(value) < 1e-9 * step) return "0";
  const double size = std::abs(value);
  if (size >= 1e5 || size < 1e-3) return fmt::format("{:.3g}", value);
  const int decimals =
      static_cast<int>(std::clamp(-std::floor(std::log10(step)), 0.0, 6.0));
  return fmt::format("{:.{}f}", value, decimals);
}

double round_step(double rough) {
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= rough * (1.0 - 1e-9)) return factor * power;
  }
  return 10.0 * power;
}

std::vector<Tick> ticks_by(double lo, double hi, double step) {
  constexpr int too_many = 1000;
  std::vector<Tick> found;
  const double first = std::ceil(lo / step - 1e-9);
  for (int i = 0; i < too_many; ++i) {
    const double value = (first + i) * step;
    if (value > hi + 1e-9 * step) break;
    found.push_back({value, label(value, step)});
  }
  return found;
}

std::vector<Tick> linear_ticks(double lo, double hi, int most) {
  double step = round_step((hi - lo) / std::max(most, 1));
  if (!(step > 0.0) || !std::isfinite(step)) return {};
  std::vector<Tick> found = ticks_by(lo, hi, step);
  // One alone does not say how large anything is.
  constexpr double next_smaller = 0.4;
  while (found.size() < 2) {
    step = round_step(next_smaller * step);
    found = ticks_by(lo, hi, step);
  }
  return found;
}

std::vector<Tick> log_ticks(double lo, double hi, int most) {
  const int low = static_cast<int>(std::ceil(std::log10(lo) - 1e-9));
  const int high = static_cast<int>(std::floor(std::log10(hi) + 1e-9));
  std::vector<Tick> found;
  const int decades = high - low + 1;
  if (decades >= 2) {
    const int every = 1 + (decades - 1) / std::max(most, 1);
    for (int e = low; e <= high; e += every) {
      const double value = std::pow(10.0, e);
      found.push_back({value, fmt::format("{:g}", value)});
    }
    return found;
  }
  for (int e = low - 1; e <= high; ++e) {
    for (const double factor : {1.0, 2.0, 5.0}) {
      const double value = factor * std::pow(10.0, e);
      if (value < lo * (1 - 1e-9) || value > hi * (1 + 1e-9)) continue;
      found.push_back({value, fmt::format("{:g}", value)});
    }
  }
  return found.size() < 2 ? linear_ticks(lo, hi, most) : found;
}

}  // namespace

std::vector<Tick> ticks(double lo, double hi, bool log, int most) {
  if (!std::isfinite(lo) || !std::isfinite(hi) || !(lo < hi)) return {};
  if (!log) return linear_ticks(lo, hi, std::max(most, 2));
  if (!(lo > 0.0)) return {};
  return log_ticks(lo, hi, std::max(most, 2));
}

std::vector<Tick> degree_ticks(double lo, double hi, int most) {
  constexpr double quarter = 90.0;
  if (!std::isfinite(lo) || !std::isfinite(hi) || !(lo < hi)) return {};
  for (double step = quarter; step <= 4.0 * quarter; step *= 2.0) {
    std::vector<Tick> found = ticks_by(lo, hi, step);
    const int count = static_cast<int>(found.size());
    if (count >= 2 && count <= std::max(most, 3)) return found;
  }
  return linear_ticks(lo, hi, std::max(most, 2));
}

}  // namespace tapfit::tui
