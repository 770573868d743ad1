#include "tui/report/report_parameters.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "tui/report/report_words.hpp"
#include "tui/screen/number.hpp"
#include "updating/properties/uncertain_property.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

namespace tapfit::tui {
namespace {

using updating::Estimate;

IdentifiedRow row_of(const Estimate& estimate, std::optional<double> nominal) {
  const Quantity found = quantity(estimate);
  const std::string unit = found.unit.empty() ? "" : " " + found.unit;
  const bool determined = found.value != "not determined";
  IdentifiedRow row{"",
                    found.name,
                    found.value + (determined ? unit : ""),
                    found.interval + unit,
                    "–",
                    "–"};
  if (nominal && *nominal != 0.0) {
    row.nominal = value_words(estimate, *nominal);
    if (determined) {
      row.change =
          signed_percent_words(100.0 * (estimate.value / *nominal - 1.0));
    }
  }
  return row;
}

/// "MAT1 1", "element property 2".
std::string card_words(const structure::Deck& deck,
                       const acquisition::UncertainProperty& uncertain) {
  const int id = uncertain.id;
  std::string card = "property";
  if (uncertain.card == "material") {
    const auto found = deck.materials.find(id);
    const bool turned =
        found != deck.materials.end() && found->second.orthotropic;
    card = deck.given != nullptr ? "material" : turned ? "MAT8" : "MAT1";
  } else if (deck.shell_properties.contains(id)) {
    card = "PSHELL";
  } else if (deck.bar_properties.contains(id)) {
    card = "PBAR";
  } else if (deck.rod_properties.contains(id)) {
    card = "PROD";
  }
  return fmt::format("{} {}", card, id);
}

/// What a field's letter on its card stands for.
std::string property_words(const std::string& property) {
  using Pair = std::pair<std::string_view, std::string_view>;
  static constexpr std::array<Pair, 11> known{{
      {"E", "Young's modulus"},
      {"E1", "Young's modulus"},
      {"E2", "Young's modulus"},
      {"G12", "shear modulus"},
      {"nu", "Poisson's ratio"},
      {"rho", "density"},
      {"t", "thickness"},
      {"A", "area"},
      {"I1", "second moment of area"},
      {"I2", "second moment of area"},
      {"J", "torsion constant"},
  }};
  const auto found = std::ranges::find(known, property, &Pair::first);
  return found == known.end() ? property : std::string(found->second);
}

IdentifiedRow property_row(const acquisition::TestBundle& bundle,
                           const structure::Deck& deck,
                           const Estimate& estimate) {
  for (const acquisition::UncertainProperty& uncertain : bundle.uncertain) {
    if (estimate.name !=
        fmt::format("{}:{}", uncertain.property, uncertain.id)) {
      continue;
    }
    try {
      const updating::PropertyLaw law =
          updating::property_law(deck, uncertain, "uncertain");
      IdentifiedRow row = row_of(estimate, law.nominal);
      row.what = fmt::format(
          "{} ({})", uncertain.property, card_words(deck, uncertain));
      row.quantity = property_words(uncertain.property);
      return row;
    } catch (const InputError&) {
      break;
    }
  }
  IdentifiedRow row = row_of(estimate, std::nullopt);
  row.what = std::exchange(row.quantity, "factor");
  return row;
}

/// What the sheets say of the sensors that the effect is at, where they agree.
std::optional<double> sheet_mass(const acquisition::TestBundle& bundle,
                                 const updating::Rung& rung,
                                 const std::string& parameter) {
  if (!parameter.starts_with("mass_kg") || rung.where.channels.empty()) {
    return std::nullopt;
  }
  const std::size_t dot = parameter.find('.');
  std::optional<double> mass;
  for (const acquisition::Channel& channel : bundle.channels) {
    const bool meant =
        dot == std::string::npos
            ? std::ranges::count(rung.where.channels, channel.name) > 0
            : channel.name == parameter.substr(dot + 1);
    if (!meant) continue;
    if (!channel.mass_kg || (mass && *mass != *channel.mass_kg)) {
      return std::nullopt;
    }
    mass = channel.mass_kg;
  }
  return mass;
}

bool is_effect(const updating::Rung& rung) {
  return rung.added != updating::base_rung &&
         rung.added != updating::uncertain_rung;
}

}  // namespace

std::string change_words(const acquisition::TestBundle& bundle,
                         const structure::Deck& deck,
                         const Estimate& estimate) {
  const std::string change = property_row(bundle, deck, estimate).change;
  return change == "–" ? std::string() : change;
}

std::vector<IdentifiedRow> identified_rows(
    const acquisition::TestBundle& bundle, const ModelResults& model) {
  std::size_t of_effects = 0;
  for (const updating::Rung& rung : model.ladder) {
    if (is_effect(rung)) of_effects += rung.parameters.size();
  }
  const std::vector<Estimate>& all = model.parameters;
  // Rungs hold what was found when each was the last: only their number counts.
  const std::size_t properties =
      all.size() >= of_effects ? all.size() - of_effects : all.size();
  std::vector<IdentifiedRow> rows;
  std::size_t at = properties;
  for (const updating::Rung& rung : model.ladder) {
    if (!is_effect(rung)) continue;
    std::vector<Estimate> own;
    for (std::size_t k = 0; k < rung.parameters.size() && at < all.size();
         ++k, ++at) {
      own.push_back(all[at]);
      own.back().name = rung.parameters[k].name;
    }
    const std::size_t first = rows.size();
    for (const Estimate& estimate : told(std::move(own))) {
      rows.push_back(row_of(estimate, sheet_mass(bundle, rung, estimate.name)));
    }
    if (rows.size() > first) {
      rows[first].what = found_words(rung.added, rung.where);
    }
  }
  for (std::size_t k = 0; k < properties; ++k) {
    rows.push_back(property_row(bundle, model.deck, all[k]));
  }
  return rows;
}

}  // namespace tapfit::tui
