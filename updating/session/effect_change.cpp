#include "updating/session/effect_change.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "updating/session/added_effect.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <utility>

namespace tapfit::updating {
namespace {

using Effects = std::vector<AddedEffect>;

std::optional<EffectChange> change_between(const Effects& before,
                                           const Effects& after) {
  if (after.size() > before.size()) {
    EffectChange change;
    for (std::size_t i = before.size(); i < after.size(); ++i) {
      if (i > before.size() && !after[i].together) return std::nullopt;
      change.added.push_back(after[i].ref);
    }
    return change;
  }
  if (after.size() < before.size()) return std::nullopt;
  for (std::size_t i = 0; i < after.size(); ++i) {
    if (after[i].on != before[i].on) return EffectChange{{}, i};
  }
  return std::nullopt;
}

Effects after(Effects effects, const EffectChange& change) {
  if (!change.switched) {
    return with_added(std::move(effects), change.added);
  }
  if (*change.switched >= effects.size()) {
    throw InputError(
        fmt::format("there is no effect {} to switch", *change.switched + 1),
        "what was undone",
        "take it out of the saved session");
  }
  bool& on = effects[*change.switched].on;
  on = !on;
  return effects;
}

}  // namespace

Effects with_added(Effects effects, const std::vector<EffectRef>& more) {
  for (const EffectRef& ref : more) {
    effects.push_back({ref, true, &ref != more.data()});
  }
  return effects;
}

std::string counted_twice(const std::vector<EffectRef>& there,
                          const std::vector<EffectRef>& added) {
  std::set<std::string> shared;
  std::string effect;
  std::vector<EffectRef> before = there;
  for (const EffectRef& ref : added) {
    for (const EffectRef& other : before) {
      if (other.effect != ref.effect) continue;
      for (const std::string& channel : ref.where.channels) {
        if (std::ranges::count(other.where.channels, channel) == 0) continue;
        shared.insert(channel);
        effect = ref.effect;
      }
    }
    before.push_back(ref);
  }
  if (shared.empty()) return {};
  return fmt::format("{} now counts twice at {}: the sizes add up there",
                     effect,
                     fmt::join(shared, ", "));
}

std::vector<EffectChange> changes_through(const Effects& from,
                                          const std::vector<Effects>& states) {
  std::vector<EffectChange> changes;
  Effects before = from;
  for (std::size_t k = states.size(); k-- > 0;) {
    const std::optional<EffectChange> change =
        change_between(before, states[k]);
    if (!change) break;
    changes.push_back(*change);
    before = states[k];
  }
  std::ranges::reverse(changes);
  return changes;
}

std::vector<Effects> states_through(const Effects& from,
                                    const std::vector<EffectChange>& changes) {
  std::vector<Effects> states;
  Effects now = from;
  for (std::size_t k = changes.size(); k-- > 0;) {
    now = after(std::move(now), changes[k]);
    states.push_back(now);
  }
  std::ranges::reverse(states);
  return states;
}

}  // namespace tapfit::updating
