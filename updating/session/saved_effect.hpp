// An effect and its place in the session's file.
#pragma once

#include "updating/effects/effect_ref.hpp"
#include "updating/session/saved_fields.hpp"

namespace tapfit::updating::saved {

/// What is there of it.
[[nodiscard]] nlohmann::ordered_json place_json(const Location& where);
/// @throws std::out_of_range for a field that no place has; as all below
[[nodiscard]] Location where_from(const nlohmann::ordered_json& value);

/// How an effect was found, beside what it is.
void add_found(const EffectRef& ref, nlohmann::ordered_json& value);
[[nodiscard]] EffectRef found_in(const nlohmann::ordered_json& value,
                                 Location where);

/// With the fields of its place beside its name.
[[nodiscard]] nlohmann::ordered_json flat(const EffectRef& ref);
[[nodiscard]] EffectRef ref_from(const nlohmann::ordered_json& value);

}  // namespace tapfit::updating::saved
