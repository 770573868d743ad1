#include "tui/screen/number.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace tapfit::tui {

std::string number(double value, int digits) {
  if (!std::isfinite(value)) return "–";
  return fmt::format("{:.{}g}", value == 0.0 ? 0.0 : value, digits);
}

std::string fixed(double value, int decimals) {
  if (!std::isfinite(value)) return "–";
  if (std::abs(value) >= 1e7) return fmt::format("{:.3g}", value);
  const double smallest = 0.5 * std::pow(10.0, -decimals);
  if (std::abs(value) < smallest) value = 0.0;  // no "-0.00"
  return fmt::format("{:.{}f}", value, decimals);
}

std::string probability(double share) {
  if (share >= 0.0 && share < 0.0005) return "<0.1 %";
  return fixed(100.0 * share, 1) + " %";
}

std::string fitted(double value, int width) {
  for (const char* unit : {"", "k", "M", "G"}) {
    for (int decimals = 2; decimals >= 0; --decimals) {
      std::string text = fixed(value, decimals) + unit;
      if (static_cast<int>(text.size()) <= width) return text;
    }
    value /= 1000.0;
  }
  return ">";
}

std::string percent(double fraction) {
  if (!std::isfinite(fraction)) return "–";
  const double value = 100.0 * fraction;
  return fixed(value, std::abs(value) < 0.95 ? 2 : 1) + " %";
}

std::string effects_text(std::size_t count) {
  return fmt::format("{} effect{}", count, count == 1 ? "" : "s");
}

std::string with_sd(double value, double sd, int digits) {
  if (!std::isfinite(value)) return "–";
  const bool exact = !std::isfinite(sd) || sd <= 0.0;
  const double size = std::max(std::abs(value), exact ? 0.0 : sd);
  if (size == 0.0) return "0";
  const double exponent = std::floor(std::log10(size));
  const bool scientific = exponent > 5.0 || exponent < -4.0;
  const double scale = scientific ? std::pow(10.0, exponent) : 1.0;
  if (exact && scientific) {
    return fmt::format(
        "{}e{}", number(value / scale, 5), static_cast<int>(exponent));
  }
  if (exact) return number(value, 5);
  const double place = std::floor(std::log10(sd / scale));
  const int decimals =
      static_cast<int>(std::clamp(digits - 1.0 - place, 0.0, 9.0));
  std::string body = fmt::format(
      "{:.{}f} ± {:.{}f}", value / scale, decimals, sd / scale, decimals);
  if (!scientific) return body;
  return fmt::format("({})e{}", body, static_cast<int>(exponent));
}

NameAndUnit split_unit(std::string_view name) {
  using Pair = std::pair<std::string_view, std::string_view>;
  static constexpr std::array<Pair, 14> endings{{
      {"_nm_per_rad_per_m", "N m/rad/m"},
      {"_n_per_m_per_m", "N/m/m"},
      {"_n_per_m3", "N/m³"},
      {"_nm_per_rad", "N m/rad"},
      {"_ns_per_m", "N s/m"},
      {"_n_per_m", "N/m"},
      {"_kg_m2", "kg m^2"},
      {"_kg", "kg"},
      {"_hz", "Hz"},
      {"_pa", "Pa"},
      {"_percent", "%"},
      {"_s", "s"},
      {"_m", "m"},
      {"_n", "N"},
  }};
  // A shared name may carry its channel: "mass_kg.acc1".
  const std::size_t dot = name.find('.');
  const std::string_view stem = name.substr(0, dot);
  const std::string member =
      dot == std::string_view::npos ? "" : std::string(name.substr(dot));
  for (const auto& [ending, unit] : endings) {
    if (!stem.ends_with(ending) || stem.size() == ending.size()) continue;
    std::string plain(stem.substr(0, stem.size() - ending.size()));
    std::replace(plain.begin(), plain.end(), '_', ' ');
    // Else a total and its value per metre would have one name.
    if (ending.ends_with("_per_m_per_m") || ending.ends_with("_rad_per_m")) {
      plain += " per m";
    }
    return {plain + member, std::string(unit)};
  }
  if (name.starts_with("E:") || name.starts_with("E1:") ||
      name.starts_with("E2:") || name.starts_with("G")) {
    return {std::string(name), "Pa"};
  }
  if (name.starts_with("rho:")) return {std::string(name), "kg/m³"};
  std::string plain(name);
  std::replace(plain.begin(), plain.end(), '_', ' ');
  return {plain, ""};
}

std::string place(const updating::Location& where) {
  if (where.variant.empty()) return updating::describe(where);
  updating::Location plain = where;
  plain.variant.clear();
  std::string form = where.variant;
  if (form == "both") form = "rotation and translation";
  if (form == "face") form = "over its face";
  return form + ", " + updating::describe(plain);
}

std::string parameter_words(std::string_view name) {
  const std::string plain = split_unit(name).name;
  if (plain.starts_with("mesh ")) {
    return fmt::format("mesh correction ({})", plain.substr(5));
  }
  const std::size_t colon = plain.find(':');
  if (colon == std::string::npos) return plain;
  const std::string property = plain.substr(0, colon);
  using Pair = std::pair<std::string_view, std::string_view>;
  static constexpr std::array<Pair, 8> cards{{{"E", "MAT1"},
                                              {"nu", "MAT1"},
                                              {"E1", "MAT8"},
                                              {"E2", "MAT8"},
                                              {"G12", "MAT8"},
                                              {"rho", "material"},
                                              {"thickness", "PSHELL"},
                                              {"T", "PSHELL"}}};
  std::string_view card = "property";
  for (const auto& [known, on] : cards) {
    if (known == property) card = on;
  }
  return fmt::format("{} ({} {})", property, card, plain.substr(colon + 1));
}

bool is_open(const updating::Estimate& e) {
  const bool lost = std::isfinite(e.sd) && e.sd > std::abs(e.value);
  return (e.at_bound || lost) && e.lo95 < e.hi95;
}

std::string size_words(const updating::Estimate& e) {
  const std::string own = e.unit.empty() ? split_unit(e.name).unit : e.unit;
  const std::string unit = own.empty() ? "" : " " + own;
  if (!is_open(e)) return with_sd(e.value, e.sd) + unit;
  if (e.lo95 < 0.0 && e.hi95 > 0.0) {
    return fmt::format(
        "{} to {}{}", number(e.lo95, 2), number(e.hi95, 2), unit);
  }
  // The fit would go on past the nearer end.
  const bool least = e.hi95 - e.value < e.value - e.lo95;
  return least ? fmt::format("at least {}{}", number(e.lo95, 2), unit)
               : fmt::format("at most {}{}", number(e.hi95, 2), unit);
}

std::string describe(const updating::Estimate& estimate) {
  return parameter_words(estimate.name) + " " + size_words(estimate);
}

}  // namespace tapfit::tui
