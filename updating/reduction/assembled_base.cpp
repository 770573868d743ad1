#include "updating/reduction/assembled_base.hpp"

#include "acquisition/foundation/constants.hpp"
#include "acquisition/foundation/input_error.hpp"
#include "updating/corrections/deck_forms.hpp"
#include "updating/properties/uncertain_parts.hpp"
#include "updating/reduction/massless_dofs.hpp"
#include "updating/structure/assembly/assemble.hpp"
#include "updating/structure/checks/unit_checks.hpp"
#include "updating/structure/elements/dashpots.hpp"
#include "updating/structure/mesh/refine_mesh.hpp"
#include "updating/structure/solve/eigenmodes.hpp"

#include <cmath>
#include <set>
#include <utility>

namespace tapfit::updating {
namespace {

// The same with the degrees of freedom of the deck's dampers, ascending.
std::vector<int> with_dampers(const structure::Deck& deck,
                              const std::vector<int>& points) {
  std::set<int> all = structure::damped_dofs(deck);
  all.insert(points.begin(), points.end());
  return {all.begin(), all.end()};
}

BaseOptions completed(const structure::Deck& deck, BaseOptions options) {
  options.points = with_dampers(deck, options.points);
  options.driven = options.driven.empty() ? options.points
                                          : with_dampers(deck, options.driven);
  return options;
}

}  // namespace

AssembledBase::AssembledBase(
    const structure::Deck& deck,
    const std::vector<acquisition::UncertainProperty>& properties,
    const BaseOptions& wanted,
    const Progress& progress)
    : options(completed(deck, wanted)),
      uncertain(properties),
      original_grids(static_cast<Eigen::Index>(deck.grids.size())),
      mesh(options.split ? structure::refine_mesh(deck)
                         : structure::RefinedDeck{deck, {}, {}}),
      elements(mesh.deck, uncertain) {
  progress("model: assembling", 0.0);
  system = structure::assemble(mesh.deck);
  mass = structure::total_mass(mesh.deck, system);
  if (!(mass > 0.0)) {
    throw structure::no_density(deck, "the model has no mass");
  }
  if (options.split) forms = mass_forms(mesh.deck, system);
  if (const structure::SparseMatrix lent =
          regularising_mass(system, options.points, options.high_hz);
      lent.size() > 0) {
    system.M += lent;
  }
  motions = structure::free_motions(system);
  if (motions.free.empty()) {
    throw InputError("the model has no free degree of freedom",
                     deck.path.string(),
                     "check the elements and the SPC cards");
  }
  shift = std::pow(two_pi * options.high_hz * 0.25, 2);
  answers.emplace(system, motions, shift);
  parts = uncertain_parts(mesh.deck, uncertain);
  for (const UncertainPart& part : parts) {
    if (part.M.nonZeros() == 0) continue;
    part_mass.push_back({part.power, structure::total_mass(mesh.deck, part.M)});
  }
  plain = nothing_released(system, parts, forms);
}

std::vector<FormModes> form_modes(const AssembledBase& model,
                                  const std::stop_token& stop) {
  std::vector<FormModes> forms;
  for (DeckForm& form : deck_forms(model.mesh.deck)) {
    if (form.of_mass) continue;
    const structure::System other = structure::assemble(form.deck);
    const structure::Eigenmodes found =
        structure::eigenmodes_up_to(model.motions.reduce(other.K),
                                    model.motions.reduce(model.system.M),
                                    model.options.reach * model.options.high_hz,
                                    stop);
    forms.push_back(
        {std::move(form.correction),
         {model.motions.expand(found.phi).topRows(6 * model.original_grids),
          found.frequency_hz}});
  }
  return forms;
}

}  // namespace tapfit::updating
