#include "updating/corrections/mass_forms.hpp"

#include "updating/corrections/deck_forms.hpp"
#include "updating/structure/assembly/assemble.hpp"

#include <utility>

namespace tapfit::updating {

std::vector<MassForm> mass_forms(const structure::Deck& deck,
                                 const structure::System& system) {
  std::vector<MassForm> forms;
  for (DeckForm& form : deck_forms(deck)) {
    if (!form.of_mass) continue;
    structure::SparseMatrix M = structure::assemble(form.deck).M - system.M;
    forms.push_back(
        {std::move(form.correction),
         std::make_shared<const structure::Deck>(std::move(form.deck)),
         std::move(M)});
  }
  return forms;
}

structure::SparseMatrix mass_of(const MassForm& form,
                                const structure::Deck& deck,
                                const std::set<int>& elements) {
  const auto wanted = [&](int id) { return elements.contains(id); };
  return structure::assemble_mass(*form.deck, wanted) -
         structure::assemble_mass(deck, wanted);
}

}  // namespace tapfit::updating
