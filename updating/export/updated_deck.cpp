#include "updating/export/updated_deck.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "updating/catalogue/catalogue.hpp"
#include "updating/diagnosis/named_diagnosis.hpp"
#include "updating/effects/joint_cards.hpp"
#include "updating/effects/stiffness_loss.hpp"
#include "updating/fit/fit_problem.hpp"
#include "updating/properties/property_cards.hpp"
#include "updating/properties/section_shear.hpp"
#include "updating/properties/uncertain_property.hpp"
#include "updating/set_up/card_slips.hpp"
#include "updating/structure/assembly/assemble.hpp"
#include "updating/structure/edit/deck_cards.hpp"
#include "updating/structure/edit/move_elements.hpp"
#include "updating/structure/edit/release_constraints.hpp"
#include "updating/structure/edit/weaken_cards.hpp"
#include "updating/structure/solve/system.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <system_error>
#include <utility>

namespace tapfit::updating {

namespace {

effects::TestContext setting_of(const acquisition::TestBundle& bundle,
                                const structure::Deck& deck) {
  effects::TestContext context;
  context.bundle = &bundle;
  context.deck = &deck;
  context.mass_kg = structure::total_mass(deck, structure::assemble(deck));
  if (bundle.band_hz) {
    context.low_hz = bundle.band_hz->front();
    context.high_hz = bundle.band_hz->back();
  }
  context.component = measured_component(bundle, deck);
  context.components = tested_components(bundle, deck);
  return context;
}

/// The identified values in the order the effect wants them; its start value
/// for one that was not identified.
std::vector<double> values(const std::vector<Estimate>& identified,
                           const std::vector<effects::ParameterSpec>& specs) {
  std::vector<double> p;
  for (const auto& spec : specs) {
    const auto found =
        std::ranges::find(identified, spec.name, &Estimate::name);
    p.push_back(found == identified.end() ? spec.start : found->value);
  }
  return p;
}

/// Marks the id of a card, "CONM2,305,..." or "GRID,400,...", as taken.
void take_id(const std::string& card, structure::Deck& deck) {
  const std::size_t comma = card.find(',');
  if (card.starts_with('$') || comma == std::string::npos) return;
  if (card.starts_with("CORD")) return deck.cards.push_back(card);
  if (card.starts_with("DMIG")) return deck.stiffness_terms.push_back({});
  int id = 0;
  const char* first = card.data() + comma + 1;
  std::from_chars(first, card.data() + card.size(), id);
  if (id <= 0) return;
  if (card.starts_with("GRID")) {
    structure::Grid grid;
    grid.id = id;
    deck.grids.push_back(grid);
  } else {
    deck.masses.push_back({.id = id});
  }
}

/// What was identified as changes of cards; in the same order.
struct IdentifiedCards {
  std::vector<structure::CardScale> scales;
  std::vector<Estimate> estimates;
};

IdentifiedCards identified_cards(const acquisition::TestBundle& bundle,
                                 const structure::Deck& deck,
                                 const std::vector<Candidate>& added_effects,
                                 const std::vector<Estimate>& identified,
                                 const std::vector<ModelForm>& form) {
  IdentifiedCards result;
  for (const auto& uncertain : bundle.uncertain) {
    const PropertyLaw law =
        property_law(deck, uncertain, "test.json: uncertain");
    const auto found = std::ranges::find(identified, law.name, &Estimate::name);
    if (found == identified.end()) continue;
    result.scales.push_back(
        property_card(deck, uncertain, found->value / law.nominal));
    result.estimates.push_back(*found);
  }
  constexpr std::size_t k1 = 17;  // of a PBAR, the name at 0
  for (const ModelForm& found : form) {
    if (found.form != section_shear) continue;
    structure::CardScale sheared{"PBAR", found.property, {k1, k1 + 1}};
    sheared.value = shear_coefficient(found.share.value);
    result.scales.push_back(std::move(sheared));
    result.estimates.push_back(found.share);
  }
  for (const Candidate& added : added_effects) {
    if (!effects::find(added.effect).corrects_deck()) continue;
    for (const CardSlip& slip : slips_at(deck, added.where)) {
      for (const ScaledNumber& one : slip.numbers) {
        result.scales.push_back(property_card(deck, one.number, one.factor));
        result.estimates.push_back({.name = slip.edit, .value = one.factor});
      }
    }
  }
  return result;
}

std::vector<structure::WeakElements> weak_elements(
    const std::vector<Candidate>& added_effects,
    const effects::TestContext& context) {
  std::vector<structure::WeakElements> weak;
  for (const auto& added : added_effects) {
    const effects::Effect& effect = effects::find(added.effect);
    if (effect.changes_stiffness() != ChangeKind::Elements) continue;
    const std::vector<double> p =
        values(added.parameters, effect.parameters(added.where, context));
    auto groups = effects::weakened_beside(added.where, *context.deck);
    groups.insert(groups.begin(), added.where.elements);
    for (std::size_t k = 0; k < groups.size(); ++k) {
      weak.push_back(
          {{groups[k].begin(), groups[k].end()},
           p[k],
           takes_mass(added.where) ? effects::thickness_left(p[k]) : 1.0});
    }
  }
  return weak;
}

/// Effects as cards to add and as elements on other grids.
struct EffectCards {
  std::vector<std::string> added;
  structure::GridMoves moves;
};

/// The elements beside a joint take its doubled grids; false where another
/// joint has moved one of them there already.
bool move_side(const effects::JointCards& joint, structure::GridMoves& moves) {
  structure::GridMoves all = moves;
  for (const int element : joint.side) {
    for (const auto& [grid, twin] : joint.doubles) {
      if (!all[element].try_emplace(grid, twin).second) return false;
    }
  }
  moves = std::move(all);
  return true;
}

EffectCards cards_of(const std::vector<Candidate>& added_effects,
                     const acquisition::TestBundle& bundle,
                     const structure::Deck& deck) {
  structure::Deck with_ids = deck;
  effects::TestContext context = setting_of(bundle, deck);
  context.deck = &with_ids;
  EffectCards cards;
  for (const auto& added : added_effects) {
    const effects::Effect& effect = effects::find(added.effect);
    Location where = added.where;
    cards.added.push_back(fmt::format("$ {}{}{}",
                                      effect_text(added.effect, added.where),
                                      added.parameters.empty() ? "" : ": ",
                                      parameters_text(added.parameters)));
    const auto p =
        values(added.parameters, effect.parameters(added.where, context));
    if (effect.changes_stiffness() == ChangeKind::Joint) {
      const effects::JointCards joint =
          effects::joint_cards(added.where, context, p.front());
      if (!move_side(joint, cards.moves)) {
        cards.added.emplace_back(
            "$ not written: it crosses another joint at a grid");
        continue;
      }
    }
    if (!where.at.empty()) {
      const Eigen::Vector3d at(where.at[0], where.at[1], where.at[2]);
      for (std::string& card :
           structure::grid_on_arm(with_ids, where.node, at)) {
        take_id(card, with_ids);
        cards.added.push_back(std::move(card));
      }
      with_ids.grids.back().position = at;
      where.node = with_ids.grids.back().id;
      where.at.clear();
    }
    for (std::string& card : effect.bulk_data(where, context, p)) {
      take_id(card, with_ids);
      cards.added.push_back(std::move(card));
    }
  }
  return cards;
}

}  // namespace

std::vector<std::string> effect_cards(
    const std::vector<Candidate>& added_effects,
    const acquisition::TestBundle& bundle,
    const structure::Deck& deck) {
  return cards_of(added_effects, bundle, deck).added;
}

UpdatedDeck updated_deck(const acquisition::TestBundle& bundle,
                         const structure::Deck& deck,
                         const std::vector<Candidate>& added_effects,
                         const std::vector<Estimate>& identified,
                         const std::vector<ModelForm>& form) {
  const effects::TestContext context = setting_of(bundle, deck);
  std::vector<structure::Constraint> released;
  for (const auto& added : added_effects) {
    const auto out = effects::find(added.effect).released(added.where, context);
    released.insert(released.end(), out.begin(), out.end());
  }
  const IdentifiedCards cards =
      identified_cards(bundle, deck, added_effects, identified, form);
  const structure::WeakenCards weak(deck,
                                    weak_elements(added_effects, context));
  EffectCards written = cards_of(added_effects, bundle, deck);
  std::vector<bool> done;
  const structure::CardEdit rescale =
      structure::rescale_cards(cards.scales, done);
  UpdatedDeck result;
  result.changes =
      structure::change_cards(deck.path,
                              {structure::move_elements(written.moves, weak),
                               weak.edit(cards.scales, done),
                               rescale,
                               structure::release_constraints(deck, released)});
  result.added = std::move(written.added);
  for (std::size_t k = 0; k < cards.scales.size(); ++k) {
    if (done[k]) continue;
    const Estimate& estimate = cards.estimates[k];
    result.added.push_back(
        fmt::format("$ identified, not written to its card: {} {}",
                    parameters_text({estimate}),
                    estimate.unit));
  }
  return result;
}

void check_has_deck(const Session& session) {
  if (session.bundle().matrices) {
    throw InputError("the model is given as matrices: there is no deck",
                     (session.bundle().folder / "test.json").string(),
                     "leave --deck out, or give the model as a Nastran deck");
  }
}

namespace {

std::vector<std::array<double, 2>> measured_damping(const modal::ModeSet& set) {
  std::vector<std::array<double, 2>> damping;
  for (const modal::Mode& mode : set.modes) {
    const bool known = mode.damping_ratio > 0.0 && mode.frequency_hz > 0.0;
    // A table has one value at a frequency.
    const bool next =
        damping.empty() || mode.frequency_hz > damping.back()[0] * (1.0 + 1e-6);
    if (known && next)
      damping.push_back({mode.frequency_hz, mode.damping_ratio});
  }
  return damping;
}

// No card holds what fits make up for of the mesh.
std::string mesh_note(const Comparison& comparison) {
  return fmt::format(
      "$ not written: what the mesh leaves ({:.2g} % of the FRFs), for which "
      "fits make up: modes on this mesh lie beside those fitted",
      100.0 * comparison.floor_mesh);
}

}  // namespace

void check_deck_name(const acquisition::TestBundle& bundle,
                     const std::filesystem::path& path) {
  std::error_code fault;
  if (std::filesystem::exists(path, fault) &&
      !std::filesystem::is_regular_file(path, fault)) {
    throw InputError(
        "is no file: others may be written beside an updated deck, and what "
        "changed is read from it again",
        path.string(),
        "name a file");
  }
  const bool named = upper(path.extension().string()) == ".INP";
  if (!named || !bundle.deck || as_keywords(*bundle.deck, path)) return;
  throw InputError("the deck is bulk data and is written as it came",
                   path.string(),
                   "name the file .bdf or .dat");
}

WrittenDeck write_updated_deck(Session& session,
                               const std::filesystem::path& path,
                               const acquisition::OutputRule& rule,
                               const Progress& progress) {
  check_deck_name(session.bundle(), path);
  const structure::Deck& deck = session.deck(progress);
  const Diagnosis named =
      diagnosis_of_named(session.ladder(progress),
                         session.comparison(progress),
                         session.model_parameters(progress));
  UpdatedDeck updated = updated_deck(session.bundle(),
                                     deck,
                                     named.candidates,
                                     named.model_parameters,
                                     session.model_form(progress));
  updated.damping = measured_damping(session.modes(progress));
  const Comparison& comparison = session.comparison(progress);
  if (comparison.floor_mesh > 0.0) {
    updated.added.push_back(mesh_note(comparison));
  }
  return write_as_read(deck, updated, path, rule);
}

}  // namespace tapfit::updating
