#include "tui/commands/updated_deck.hpp"

#include "tui/commands/effect_output.hpp"
#include "tui/commands/text_table.hpp"
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
/// for one that the rung does not hold.
std::vector<double> values(const updating::Rung& rung,
                           const std::vector<effects::ParameterSpec>& specs) {
  std::vector<double> p;
  for (const auto& spec : specs) {
    const auto found = std::ranges::find(
        rung.parameters, spec.name, &updating::Estimate::name);
    p.push_back(found == rung.parameters.end() ? spec.start : found->value);
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

std::vector<std::string> effect_cards(const std::vector<updating::Rung>& ladder,
                                      const acquisition::TestBundle& bundle,
                                      const structure::Deck& deck) {
  structure::Deck with_ids = deck;
  effects::Setting setting = setting_of(bundle, deck);
  setting.deck = &with_ids;
  std::vector<std::string> cards;
  for (std::size_t k = 1; k < ladder.size(); ++k) {
    const updating::Rung& rung = ladder[k];
    const effects::Effect& effect = effects::find(rung.added);
    cards.push_back(fmt::format("$ {}: {}",
                                effect_text(rung.added, rung.where),
                                parameters_text(rung.parameters)));
    const auto p = values(rung, effect.parameters(rung.where, setting));
    for (std::string& card : effect.bulk_data(rung.where, setting, p)) {
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
  std::vector<std::string> cards =
      effect_cards(session.ladder(progress), session.bundle(), deck);
  for (const auto& estimate : session.model_parameters(progress)) {
    cards.push_back(fmt::format("$ identified: {} {}",
                                parameters_text({estimate}),
                                model_parameter_unit(estimate.name)));
  }
  structure::write_deck(deck, cards, path);
}

}  // namespace tapfit::tui
