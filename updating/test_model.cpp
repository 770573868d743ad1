#include "updating/test_model.hpp"

#include "acquisition/input_error.hpp"
#include "updating/structure/scale_units.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tapfit::updating {
namespace {

void check_grid(const structure::Deck& deck,
                const Dof& dof,
                const std::string& place) {
  if (!deck.has_grid(dof.node)) {
    throw InputError(
        fmt::format("the model has no grid {}", dof.node),
        place,
        fmt::format("use a grid id of {}", deck.path.filename().string()));
  }
}

bool is_held(const structure::Deck& deck, const Dof& dof) {
  const char component = static_cast<char>('0' + dof.component);
  return std::any_of(deck.constraints.begin(),
                     deck.constraints.end(),
                     [&](const structure::Constraint& c) {
                       return c.grid == dof.node &&
                              c.components.find(component) != std::string::npos;
                     });
}

void check_point(structure::Deck& deck,
                 const Dof& dof,
                 const std::string& place) {
  check_grid(deck, dof, place);
  if (!is_held(deck, dof)) return;
  deck.warnings.push_back(
      fmt::format("{}: the model holds {} at zero, so that its FRFs there are "
                  "zero whatever was measured; move the point, or free the "
                  "grid",
                  place,
                  name(dof)));
}

void check_points(const acquisition::TestBundle& bundle,
                  structure::Deck& deck) {
  for (std::size_t r = 0; r < bundle.runs.size(); ++r) {
    const acquisition::Run& run = bundle.runs[r];
    check_point(
        deck, run.hammer.dof, fmt::format("test.json: runs[{}].hammer", r));
    for (std::size_t k = 0; k < run.sensors.size(); ++k) {
      check_point(deck,
                  run.sensors[k].dof,
                  fmt::format("test.json: runs[{}].sensors[{}]", r, k));
    }
  }
}

void warn_of_dampers(structure::Deck& deck) {
  const auto dampers = std::count_if(
      deck.scalars.begin(), deck.scalars.end(), [](const auto& s) {
        return s.damping != 0.0;
      });
  if (dampers == 0) return;
  deck.warnings.push_back(fmt::format(
      "{} CDAMP of the deck are left out: damping is identified mode by mode; "
      "add a strong damper as the effect dashpot@GRID",
      dampers));
}

}  // namespace

structure::Deck read_test_model(const acquisition::TestBundle& bundle) {
  if (!bundle.deck) {
    throw InputError(bundle.matrices
                         ? "a model given as matrices cannot be compared yet"
                         : "the test has no model",
                     (bundle.folder / "test.json").string(),
                     "name a Nastran deck in the field \"model\"");
  }
  structure::Deck deck = structure::read_deck(*bundle.deck);
  structure::scale_to_si(deck, bundle.units);
  check_points(bundle, deck);
  warn_of_dampers(deck);
  return deck;
}

}  // namespace tapfit::updating
