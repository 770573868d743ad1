#include "tui/screen/number.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace tapfit::tui {

namespace {

/// To so many decimals; fewer than none: to tens, hundreds, ...
std::string rounded(double value, int decimals) {
  const double step = std::pow(10.0, -decimals);
  if (decimals < 0) value = step * std::round(value / step);
  if (std::abs(value) < 0.5 * step) value = 0.0;  // no "-0.00"
  return fmt::format("{:.{}f}", value, std::max(decimals, 0));
}

/// The power of ten of its first digit, once it is rounded to so many.
int exponent_of(double value, int digits) {
  if (value == 0.0) return 0;
  const std::string text =
      fmt::format("{:.{}e}", std::abs(value), std::max(digits, 1) - 1);
  return std::stoi(text.substr(text.find('e') + 1));
}

bool needs_power(int exponent) { return exponent > 5 || exponent < -4; }

/// How numbers that belong together are written.
struct Notation {
  int power = 0;  ///< of ten, set behind; 0: plain
  int decimals = 0;

  [[nodiscard]] std::string of(double value) const {
    return rounded(value / std::pow(10.0, power), decimals);
  }
  [[nodiscard]] std::string joined(double first,
                                   const char* sign,
                                   double second) const {
    const std::string body = of(first) + sign + of(second);
    return power == 0 ? body : fmt::format("({})e{}", body, power);
  }
};

Notation notation(double largest, double deviation, int digits) {
  const int exponent = exponent_of(largest, 17);
  const int power = needs_power(exponent) ? exponent : 0;
  const int place = exponent_of(deviation, digits) - power;
  return {power, std::min(digits - 1 - place, 9)};
}

bool has_deviation(double sd) { return std::isfinite(sd) && sd > 0.0; }

}  // namespace

std::string number(double value, int digits) {
  if (!std::isfinite(value)) return "–";
  const int exponent = exponent_of(value, digits);
  if (exponent >= digits && !needs_power(exponent)) {
    return rounded(value, digits - 1 - exponent);
  }
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
  if (has_deviation(sd)) {
    return notation(std::max(std::abs(value), sd), sd, digits)
        .joined(value, " ± ", sd);
  }
  const int exponent = exponent_of(value, 5);
  if (!needs_power(exponent)) return number(value, 5);
  return fmt::format(
      "{}e{}", number(value / std::pow(10.0, exponent), 5), exponent);
}

Spread spread(const updating::Estimate& e) {
  if (!std::isfinite(e.value) || !has_deviation(e.sd)) {
    return {with_sd(e.value, e.sd),
            fmt::format("{} … {}", number(e.lo95), number(e.hi95))};
  }
  const auto [low, high] = std::minmax({e.value, -e.value, e.lo95, e.hi95});
  const Notation alike = notation(std::max({-low, high, e.sd}), e.sd, 2);
  return {alike.joined(e.value, " ± ", e.sd),
          alike.joined(e.lo95, " … ", e.hi95)};
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
  if (e.at_bound && !(e.lo95 < e.hi95)) {
    return fmt::format("{}{}, at its bound", number(e.value, 3), unit);
  }
  if (!is_open(e)) return with_sd(e.value, e.sd) + unit;
  // The fit would go on past the nearer end.
  const bool least = e.hi95 - e.value < e.value - e.lo95;
  // Of a factor up to 1 that says nothing, below zero the contrary.
  const bool nothing = !least && e.name.ends_with("factor") && e.hi95 >= 0.995;
  if (e.lo95 < 0.0 || nothing) {
    return fmt::format(
        "{} to {}{}", number(e.lo95, 2), number(e.hi95, 2), unit);
  }
  return least ? fmt::format("at least {}{}", number(e.lo95, 2), unit)
               : fmt::format("at most {}{}", number(e.hi95, 2), unit);
}

std::string told_name(const std::string& name,
                      const std::vector<updating::Estimate>& all) {
  const std::string per_metre = "_per_m";
  if (!name.ends_with(per_metre)) return name;
  const std::string total = name.substr(0, name.size() - per_metre.size());
  const auto own = std::ranges::find(all, name, &updating::Estimate::name);
  const auto sum = std::ranges::find(all, total, &updating::Estimate::name);
  const bool same =
      own != all.end() && sum != all.end() && own->value == sum->value;
  return same ? total : name;
}

std::vector<updating::Estimate> told(
    std::vector<updating::Estimate> estimates) {
  const std::vector<updating::Estimate> all = estimates;
  std::erase_if(estimates, [&all](const updating::Estimate& e) {
    return told_name(e.name, all) != e.name;
  });
  return estimates;
}

std::string describe(const updating::Estimate& estimate) {
  return parameter_words(estimate.name) + " " + size_words(estimate);
}

}  // namespace tapfit::tui
