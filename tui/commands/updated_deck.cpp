#include "tui/commands/updated_deck.hpp"

#include "tui/commands/effect_output.hpp"
#include "tui/commands/update_command.hpp"
#include "updating/effects/catalogue.hpp"
#include "updating/structure/system.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace tapfit::tui {

namespace {

effects::Setting setting_of(const acquisition::TestBundle& bundle,
                            const structure::Deck& deck) {
  effects::Setting setting;
  setting.bundle = &bundle;
  setting.deck = &deck;
  setting.mass_kg = structure::total_mass(deck, structure::assemble(deck));
  if (bundle.band_hz) {
    setting.low_hz = bundle.band_hz->front();
    setting.high_hz = bundle.band_hz->back();
  }
  if (!bundle.runs.empty() && !bundle.runs.front().sensors.empty()) {
    setting.component = bundle.runs.front().sensors.front().dof.component;
  }
  return setting;
}

/// The identified values in the order the effect wants them; its start value
/// for one that was not identified.
std::vector<double> values(const std::vector<updating::Estimate>& identified,
                           const std::vector<effects::ParameterSpec>& specs) {
  std::vector<double> p;
  for (const auto& spec : specs) {
    const auto found =
        std::ranges::find(identified, spec.name, &updating::Estimate::name);
    p.push_back(found == identified.end() ? spec.start : found->value);
  }
  return p;
}

/// Marks the element id of a card, "CONM2,305,...", as taken.
void take_id(const std::string& card, structure::Deck& deck) {
  const std::size_t comma = card.find(',');
  if (card.starts_with('$') || comma == std::string::npos) return;
  int id = 0;
  const char* first = card.data() + comma + 1;
  std::from_chars(first, card.data() + card.size(), id);
  if (id > 0) deck.masses.push_back({.id = id});
}

}  // namespace

std::vector<std::string> effect_cards(
    const std::vector<updating::Candidate>& added_effects,
    const acquisition::TestBundle& bundle,
    const structure::Deck& deck) {
  structure::Deck with_ids = deck;
  effects::Setting setting = setting_of(bundle, deck);
  setting.deck = &with_ids;
  std::vector<std::string> cards;
  for (const auto& added : added_effects) {
    const effects::Effect& effect = effects::find(added.effect);
    cards.push_back(fmt::format("$ {}: {}",
                                effect_text(added.effect, added.where),
                                parameters_text(added.parameters)));
    const auto p =
        values(added.parameters, effect.parameters(added.where, setting));
    for (std::string& card : effect.bulk_data(added.where, setting, p)) {
      take_id(card, with_ids);
      cards.push_back(std::move(card));
    }
  }
  return cards;
}

void write_updated_deck(updating::Session& session,
                        const std::filesystem::path& path,
                        const Progress& progress) {
  const structure::Deck& deck = session.deck(progress);
  const updating::Diagnosis named =
      diagnosis_of_named(session.ladder(progress),
                         session.comparison(progress),
                         session.model_parameters(progress));
  std::vector<std::string> cards =
      effect_cards(named.candidates, session.bundle(), deck);
  for (const auto& estimate : named.model_parameters) {
    cards.push_back(fmt::format("$ identified, not written to its card: {} {}",
                                parameters_text({estimate}),
                                model_parameter_unit(estimate.name)));
  }
  structure::write_deck(deck, cards, path);
}

}  // namespace tapfit::tui
