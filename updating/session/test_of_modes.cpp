#include "updating/session/test_of_modes.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "updating/catalogue/catalogue.hpp"

namespace tapfit::updating {

namespace {

void check_shown(const std::vector<EffectRef>& effects,
                 const char* where,
                 const char* remedy) {
  for (const EffectRef& ref : effects) {
    if (effects::find(ref.effect).shows_in_modes()) continue;
    throw InputError(
        "modes do not tell of the effect " + ref.effect, where, remedy);
  }
}

}  // namespace

void check_shown_in_modes(const std::vector<EffectRef>& effects) {
  check_shown(effects,
              "the effect to be added",
              "name one that changes stiffness or mass, or give the test's "
              "FRFs or recordings in place of its modes");
}

void check_saved_shown_in_modes(const SavedSession& saved) {
  std::vector<EffectRef> effects;
  for (const AddedEffect& added : saved.effects) effects.push_back(added.ref);
  for (const EffectChange& change : saved.undone) {
    effects.insert(effects.end(), change.added.begin(), change.added.end());
  }
  check_shown(effects,
              "the saved session",
              "move its file away, or give the test's FRFs or recordings in "
              "place of its modes");
}

void check_choice_for_modes(const UpdateChoice& choice) {
  if (!choice.is_plain()) return;
  throw InputError("there are no lines and no lambda to choose",
                   "the test consists of modes",
                   "leave the choice out");
}

}  // namespace tapfit::updating
