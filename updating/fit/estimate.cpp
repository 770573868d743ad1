#include "updating/fit/estimate.hpp"

#include <fmt/format.h>

namespace tapfit::updating {

namespace {

/// Two digits, without an exponent where that can be helped.
std::string sd_text(double sd) {
  return sd >= 10.0 && sd < 1e5 ? fmt::format("{:.0f}", sd)
                                : fmt::format("{:.2g}", sd);
}

}  // namespace

std::string parameters_text(const std::vector<Estimate>& parameters) {
  std::string text;
  for (const auto& estimate : parameters) {
    if (!text.empty()) text += ", ";
    text += fmt::format("{} {} +- {}",
                        estimate.name,
                        fmt::format("{:.4g}", estimate.value),
                        sd_text(estimate.sd));
    if (estimate.at_bound) text += " (at its bound)";
  }
  return text;
}

}  // namespace tapfit::updating
