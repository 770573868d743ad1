#include "updating/test_model.hpp"

#include "acquisition/input_error.hpp"
#include "updating/structure/scale_units.hpp"

#include <fmt/format.h>

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

void check_grids(const acquisition::TestBundle& bundle,
                 const structure::Deck& deck) {
  for (std::size_t r = 0; r < bundle.runs.size(); ++r) {
    const acquisition::Run& run = bundle.runs[r];
    check_grid(
        deck, run.hammer.dof, fmt::format("test.json: runs[{}].hammer", r));
    for (std::size_t k = 0; k < run.sensors.size(); ++k) {
      check_grid(deck,
                 run.sensors[k].dof,
                 fmt::format("test.json: runs[{}].sensors[{}]", r, k));
    }
  }
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
  check_grids(bundle, deck);
  return deck;
}

}  // namespace tapfit::updating
