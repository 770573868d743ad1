// What was undone and can be done again, told as changes: a saved session has
// the effects once, and of a redo only what it would do to them.
#pragma once

#include "updating/effects/effect_ref.hpp"
#include "updating/session/added_effect.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace tapfit::updating {

/// One change of the effects: some were added, or one that was there switched.
struct EffectChange {
  std::vector<EffectRef> added;           ///< where nothing was switched
  std::optional<std::size_t> switched{};  ///< counted from 0

  bool operator==(const EffectChange&) const = default;
};

/// The effects with more of them, added in one step.
[[nodiscard]] std::vector<AddedEffect> with_added(
    std::vector<AddedEffect> effects, const std::vector<EffectRef>& more);

/// Where an effect comes to a channel that has it already: each is a parameter
/// of its own, and their sizes add up there.
/// @return "sensor-mass now counts twice at acc1: the sizes add up there";
/// empty
///   where none does
[[nodiscard]] std::string counted_twice(const std::vector<EffectRef>& there,
                                        const std::vector<EffectRef>& added);

/// What leads from one state to the next; the list ends early where that is no
/// single change.
/// @param states what a redo goes on to, the next one last
/// @return the next one last, too
[[nodiscard]] std::vector<EffectChange> changes_through(
    const std::vector<AddedEffect>& from,
    const std::vector<std::vector<AddedEffect>>& states);

/// The inverse: the states that changes lead through.
/// @throws InputError for one that switches an effect which is not there
[[nodiscard]] std::vector<std::vector<AddedEffect>> states_through(
    const std::vector<AddedEffect>& from,
    const std::vector<EffectChange>& changes);

}  // namespace tapfit::updating
