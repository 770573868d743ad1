#include "updating/prediction/stated_change.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "updating/catalogue/catalogue.hpp"
#include "updating/catalogue/effect_place.hpp"
#include "updating/fit/fitter.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <charconv>
#include <cmath>

namespace tapfit::updating {
namespace {

/// A unit that parameters whose names end so may be stated in.
struct SizeUnit {
  const char* ending;
  const char* unit;
  double si;
};

constexpr std::array<SizeUnit, 15> size_units{{{"_kg", "kg", 1.0},
                                               {"_kg", "g", 1e-3},
                                               {"_kg", "mg", 1e-6},
                                               {"_kg", "lb", 0.45359237},
                                               {"_kg", "oz", 0.45359237 / 16},
                                               {"_n_per_m", "N/m", 1.0},
                                               {"_n_per_m", "N/mm", 1e3},
                                               {"_n_per_m", "kN/m", 1e3},
                                               {"_n_per_m", "kN/mm", 1e6},
                                               {"_ns_per_m", "Ns/m", 1.0},
                                               {"_n", "N", 1.0},
                                               {"_n", "kN", 1e3},
                                               {"_hz", "Hz", 1.0},
                                               {"_ratio", "%", 1e-2},
                                               {"factor", "%", 1e-2}}};

/// Without the channel or end that it is of: "mass_kg" of "mass_kg.acc1".
std::string without_owner(const std::string& parameter) {
  return parameter.substr(0, parameter.find('.'));
}

std::string in_quotes(const std::string& text) {
  return fmt::format("effect \"{}\"", text);
}

StatedSize read_size(const std::string& part, const std::string& text) {
  StatedSize size;
  const char* end = part.data() + part.size();
  const auto [rest, fault] = std::from_chars(part.data(), end, size.value);
  if (fault != std::errc{} || !std::isfinite(size.value)) {
    throw InputError(fmt::format("the size \"{}\" is no number", part),
                     in_quotes(text),
                     "write it in SI units (0.010) or with its unit (10g), "
                     "several joined with \",\"");
  }
  size.unit.assign(rest, end);
  const std::size_t begin = size.unit.find_first_not_of(' ');
  size.unit.erase(0, std::min(begin, size.unit.size()));
  return size;
}

double in_si(const StatedSize& size,
             const effects::ParameterSpec& parameter,
             const std::string& effect) {
  if (size.unit.empty()) return size.value;
  std::vector<std::string> known;
  for (const SizeUnit& unit : size_units) {
    if (!without_owner(parameter.name).ends_with(unit.ending)) continue;
    if (size.unit == unit.unit) return size.value * unit.si;
    known.emplace_back(unit.unit);
  }
  throw InputError(
      fmt::format("\"{}\" is no unit of {}", size.unit, parameter.name),
      in_quotes(effect),
      known.empty() ? "write the number alone, in SI units"
                    : fmt::format("write the number alone, in SI units, or in "
                                  "one of {}",
                                  fmt::join(known, ", ")));
}

void check_is_change(const effects::Effect& effect, const std::string& text) {
  if (!effect.is_mistake() && effect.entry() != effects::Entry::Damping) return;
  throw InputError(
      fmt::format("{} is no change of the structure", effect.name()),
      in_quotes(text),
      "state a mass, spring, damper, loss of stiffness, support, joint or "
      "axial force; what was fitted along is named by --with");
}

}  // namespace

StatedChange parse_stated_change(const std::string& text) {
  const std::size_t equals = text.rfind('=');
  StatedChange change;
  change.ref = parse_effect(text.substr(0, equals));
  check_is_change(effects::find(change.ref.effect), text);
  if (equals == std::string::npos || equals + 1 == text.size()) {
    throw InputError("no size is stated",
                     in_quotes(text),
                     fmt::format("write it behind =, in SI units or with its "
                                 "unit, for example {}=0.010",
                                 text.substr(0, equals)));
  }
  for (std::size_t at = equals + 1; at <= text.size();) {
    const std::size_t end = std::min(text.find(',', at), text.size());
    change.sizes.push_back(read_size(text.substr(at, end - at), text));
    at = end + 1;
  }
  return change;
}

EffectInstance place_change(const StatedChange& change,
                            const effects::TestContext& context) {
  EffectInstance placed = place_effect(change.ref, context);
  const std::string name = effect_text(change.ref.effect, placed.where);
  const std::vector<effects::ParameterSpec> specs =
      placed.effect->parameters(placed.where, context);
  if (change.sizes.size() != specs.size()) {
    std::vector<std::string> names;
    for (const auto& spec : specs) names.push_back(spec.name);
    throw InputError(
        fmt::format("{} size{} stated, not {}",
                    change.sizes.size(),
                    change.sizes.size() == 1 ? " is" : "s are",
                    specs.size()),
        in_quotes(name),
        fmt::format("state {}, joined with \",\"", fmt::join(names, ", ")));
  }
  for (std::size_t k = 0; k < specs.size(); ++k) {
    const double value = in_si(change.sizes[k], specs[k], name);
    placed.p[k] = specs[k].sign * value;
    if (placed.p[k] > 0.0) continue;
    throw InputError(
        fmt::format("{} = {:.6g} is no size", specs[k].name, value),
        in_quotes(name),
        specs[k].sign < 0.0 ? "state it below zero" : "state it above zero");
  }
  return placed;
}

void check_size(const EffectInstance& change, const FrfModel& model) {
  const std::vector<effects::ParameterSpec> specs =
      parameters_of(change, model);
  // Of a base that holds a change of stiffness only sizes in its range are.
  const bool bounded_below = change.effect->changes_stiffness().has_value();
  for (std::size_t k = 0; k < specs.size(); ++k) {
    const auto& [name, start, lower, upper, sign] = specs[k];
    constexpr double rounding = 1e-9;
    const bool low = bounded_below && change.p[k] < lower * (1.0 - rounding);
    if (!low && change.p[k] <= upper * (1.0 + rounding)) continue;
    throw InputError(
        fmt::format("{} = {:.6g} is out of range", name, sign * change.p[k]),
        in_quotes(effect_text(change.effect->name(), change.where)),
        fmt::format("state one from {:.4g} to {:.4g}, or change "
                    "the deck itself",
                    sign * (bounded_below ? lower : 0.0),
                    sign * upper));
  }
}

std::string change_text(const EffectInstance& change,
                        const effects::TestContext& context) {
  std::string text = effect_text(change.effect->name(), change.where);
  const std::vector<effects::ParameterSpec> specs =
      change.effect->parameters(change.where, context);
  for (std::size_t k = 0; k < specs.size(); ++k) {
    text +=
        fmt::format(", {} {:.6g}", specs[k].name, specs[k].sign * change.p[k]);
  }
  return text;
}

}  // namespace tapfit::updating
