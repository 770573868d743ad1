#include "tui/report/report_words.hpp"

#include "tui/screen/number.hpp"
#include "updating/catalogue/catalogue.hpp"
#include "updating/effects/effect_ref.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <regex>
#include <string_view>
#include <utility>

namespace tapfit::tui {
namespace {

std::string replaced(std::string text,
                     std::string_view what,
                     std::string_view by) {
  for (std::size_t at = text.find(what); at != std::string::npos;
       at = text.find(what, at + by.size())) {
    text.replace(at, what.size(), by);
  }
  return text;
}

std::string words_of(const std::string& name) {
  if (name == "base") return "model as delivered";
  if (name == "none") return "nothing missing";
  if (name == updating::nonlinearity) return "nonlinear behaviour";
  for (const effects::Effect* effect : effects::catalogue()) {
    if (effect->name() == name) return effect->words();
  }
  return replaced(name, "-", " ");
}

struct Prefix {
  double factor = 1.0;  ///< on the value in SI
  std::string unit;
};

Prefix prefix_of(const std::string& unit, double value) {
  const double size = std::abs(value);
  if (unit == "Pa" && size >= 1e9) return {1e-9, "GPa"};
  if (unit == "Pa" && size >= 1e6) return {1e-6, "MPa"};
  if (unit == "kg" && size > 0.0 && size < 1.0) return {1e3, "g"};
  if (unit == "kg m^2" && size > 0.0 && size < 1.0) return {1e6, "kg·mm²"};
  if (unit == "s" && size > 0.0 && size < 1e-3) return {1e6, "µs"};
  if (unit == "s" && size > 0.0 && size < 1.0) return {1e3, "ms"};
  if (unit == "m" && size > 0.0 && size < 1.0) return {1e3, "mm"};
  if (unit == "m^2" && size > 0.0 && size < 1.0) return {1e6, "mm²"};
  if (unit == "m^4" && size > 0.0 && size < 1.0) return {1e12, "mm⁴"};
  std::string written = replaced(unit, "N m", "N·m");
  written = replaced(written, "N s", "N·s");
  written = replaced(written, "kg m", "kg·m");
  using Power = std::pair<std::string_view, std::string_view>;
  for (const auto& [plain, power] :
       {Power{"^2", "²"}, Power{"^3", "³"}, Power{"^4", "⁴"}}) {
    written = replaced(written, plain, power);
  }
  return {1.0, written == "1" ? std::string() : written};
}

/// "7e10", "1.4e+05" and "(7.07 ± 0.02)e10" as "7·10¹⁰", ...
std::string with_powers(const std::string& text) {
  static const std::regex power(R"(([\d)])e([+-]?)0*(\d+)\b)");
  static constexpr std::array<const char*, 10> raised{
      "⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string typed;
  auto rest = text.cbegin();
  for (std::sregex_iterator at(text.begin(), text.end(), power), end; at != end;
       ++at) {
    typed.append(rest, (*at)[1].second);
    typed += (*at)[2] == "-" ? "·10⁻" : "·10";
    for (const char digit : at->str(3)) {
      typed += raised.at(static_cast<std::size_t>(digit - '0'));
    }
    rest = (*at)[0].second;
  }
  return typed.append(rest, text.cend());
}

std::string unit_of(const updating::Estimate& estimate) {
  return estimate.unit.empty() ? split_unit(estimate.name).unit : estimate.unit;
}

std::string plain_name(const std::string& name) {
  const std::string plain = split_unit(name).name;
  return plain.starts_with("mesh ")
             ? fmt::format("mesh correction ({})", plain.substr(5))
             : plain;
}

}  // namespace

std::string typeset(std::string text) {
  static const std::regex minus(R"((^|[ (])-(?=\d))");
  text = std::regex_replace(with_powers(text), minus, "$1−");
  text = replaced(std::move(text), "`", "");
  text = replaced(std::move(text), "+-", "±");
  text = replaced(std::move(text), " ... ", " … ");
  text = replaced(std::move(text), "m/s^2", "m/s²");
  text = replaced(std::move(text), "kg/m^3", "kg/m³");
  return replaced(std::move(text), "N m/rad", "N·m/rad");
}

std::string effect_words(const std::string& effect) {
  std::string text;
  for (std::size_t at = 0; at <= effect.size();) {
    const std::size_t end =
        std::min(effect.find_first_of("|+", at), effect.size());
    text += words_of(effect.substr(at, end - at));
    if (end < effect.size()) text += effect[end] == '|' ? " or " : " and ";
    at = end + 1;
  }
  return text;
}

std::string place_words(const updating::Location& where) {
  updating::Location plain = where;
  plain.variant.clear();
  std::string text = typeset(updating::describe(plain));
  if (text == "everywhere") text.clear();
  // It will stand in brackets itself.
  if (text.ends_with(')')) text = replaced(text, " (", ", "), text.pop_back();
  std::string variant = where.variant;
  if (variant == "each") variant = "one for each channel";
  if (variant == "rotary") variant = "with rotary inertia";
  if (is_direction(where)) variant = "along " + variant;
  if (variant == "both") variant = "rotation and translation";
  if (variant == "face") variant = "over its face";
  if (variant.empty()) return text;
  return text + (text.empty() ? "" : "; ") + variant;
}

std::string found_words(const std::string& effect,
                        const updating::Location& where) {
  const std::string place = place_words(where);
  if (place.empty()) return effect_words(effect);
  // The place is the leading kind's: another may sit elsewhere.
  const std::size_t end = std::min(effect.find('|'), effect.size());
  std::string text =
      fmt::format("{} ({})", effect_words(effect.substr(0, end)), place);
  if (end < effect.size())
    text += " or " + effect_words(effect.substr(end + 1));
  return text;
}

std::string with_article(const std::string& found) {
  if (found.starts_with("mass of the") || found.starts_with("pull of the")) {
    return "the " + found;
  }
  if (found.starts_with("two ") || found.starts_with("nonlinear")) {
    return found;
  }
  const bool vowel = found.find_first_of("aeiou") == 0;
  return (vowel ? "an " : "a ") + found;
}

Quantity quantity(const updating::Estimate& estimate) {
  const Prefix prefix = prefix_of(unit_of(estimate), estimate.value);
  const double f = prefix.factor;
  // Wider than the value itself, a deviation says nothing more.
  const bool lost =
      estimate.sd >= std::abs(estimate.value) && estimate.sd > 0.0;
  updating::Estimate scaled = estimate;
  scaled.value *= f;
  scaled.lo95 *= f;
  scaled.hi95 *= f;
  scaled.sd = lost ? (scaled.hi95 - scaled.lo95) / 4.0 : f * estimate.sd;
  const Spread words = spread(scaled);
  Quantity found{plain_name(estimate.name),
                 typeset(words.value),
                 typeset(words.interval),
                 prefix.unit};
  if (lost) {
    found.value = "not determined";
  } else if (estimate.at_bound) {
    found.value += " (at its bound)";
  }
  return found;
}

std::string value_words(const updating::Estimate& like, double value) {
  const Prefix prefix = prefix_of(unit_of(like), like.value);
  return fmt::format("{}{}{}",
                     typeset(number(prefix.factor * value)),
                     prefix.unit.empty() ? "" : " ",
                     prefix.unit);
}

std::string next_words(const updating::NextMeasurement& next, double floor) {
  // Of one effect at two places it is the places that are to be told apart.
  const bool same = next.one.effect == next.other.effect &&
                    next.one.where.variant == next.other.where.variant;
  const auto named = [same](const updating::EffectRef& ref) {
    return same ? place(ref.where)
                : with_article(found_words(ref.effect, ref.where));
  };
  const std::string one = named(next.one);
  const std::string other = named(next.other);
  if (!is_significant(next, floor)) {
    return fmt::format(
        "No hit or sensor point would separate {} from {}: their "
        "predictions differ by {} at most, the floor is {}.",
        one,
        other,
        percent(next.difference),
        percent(floor));
  }
  return fmt::format(
      "To separate {} from {}: hit {} with {} {} {} (they differ by {} "
      "there, by {} at your points).",
      one,
      other,
      name(next.hit),
      next.channel,
      next.moves_sensor ? "moved to" : "at",
      name(next.sensor),
      percent(next.difference),
      percent(next.difference_now));
}

std::string floor_words(const updating::Comparison& c) {
  std::string words = fmt::format(
      "noise {}, mesh {}", percent(c.floor_noise), percent(c.floor_mesh));
  if (c.floor_form > 0.0) words += ", form " + percent(c.floor_form);
  return words;
}

std::string contour_words(const std::string& contour) {
  static const std::regex line(
      R"((\d+) lines from (\S+) to (\S+) Hz on s = sigma \+ j omega, )"
      R"(sigma = (\S+) omega.*)");
  std::smatch found;
  if (!std::regex_match(contour, found, line)) return typeset(contour);
  return fmt::format(
      "evaluated at {} frequencies, {}–{} Hz, with {} % added damping",
      found.str(1),
      number(std::strtod(found.str(2).c_str(), nullptr)),
      number(std::strtod(found.str(3).c_str(), nullptr)),
      number(100.0 * std::strtod(found.str(4).c_str(), nullptr)));
}

std::string on_contour(const std::string& contour) {
  const std::string words = contour_words(contour);
  return words.starts_with("evaluated at ") ? words : "on " + words;
}

std::string drop_words(double without, double with) {
  return fmt::format(
      "error {} without it, {} with it", percent(without), percent(with));
}

std::string four_digits(double value) {
  if (!std::isfinite(value)) return "–";
  const int before = static_cast<int>(std::floor(
                         std::log10(std::max(std::abs(value), 1e-300)))) +
                     1;
  return fixed(value, std::clamp(4 - before, 0, 4));
}

std::string signed_words(double value) {
  const std::string text = typeset(fixed(value, 2));
  return (value > 0.0 && text != "0.00" ? "+" : "") + text;
}

std::string signed_percent_words(double percent) {
  return signed_words(percent) + " %";
}

std::string enumerated(const std::vector<std::string>& items) {
  std::string text;
  for (std::size_t k = 0; k < items.size(); ++k) {
    if (k > 0) text += k + 1 == items.size() ? " and " : ", ";
    text += items[k];
  }
  return text;
}

std::string capitalised(std::string text) {
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') {
    text[0] = static_cast<char>(text[0] - 'a' + 'A');
  }
  return text;
}

std::string law_name(const updating::SignatureLaw& law) {
  if (law.effect == "mass") return "a pure mass";
  return (law.effect == "absorber" ? "an " : "a ") + law.effect;
}

}  // namespace tapfit::tui
