// Where the test's own points are on the model, as text and JSON.
#pragma once

#include "updating/structure/deck/deck.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace tapfit::tui {

/// A table of the points: what carries each, how far its coordinates are from
/// that, and the nearest grid; under it how the test's mesh was laid over the
/// model. Empty where the test has no points of its own.
[[nodiscard]] std::string point_places_text(const structure::Deck& deck);

/// {"point_places": [...], "laid_over": {...}} added to an object; nothing
/// where the test has no points of its own.
void add_point_places(const structure::Deck& deck,
                      nlohmann::ordered_json& object);

}  // namespace tapfit::tui
