// What places are written as: ids joined by ":" or ",", and points of the test.
#pragma once

#include "updating/effects/effect.hpp"
#include "updating/effects/effect_ref.hpp"
#include "updating/places/location.hpp"

#include <string>
#include <vector>

namespace tapfit::updating {

/// Joined by ":", or by "," as places are told.
[[nodiscard]] std::vector<std::string> parts_of(const std::string& text);

/// The numbers of "60:56", or nothing where it is no such list.
[[nodiscard]] std::vector<int> numbers_in(const std::string& text);

[[nodiscard]] bool is_grid(const std::string& part);

/// The number of a point of the test, 2 of "P2"; 0 where it is none.
[[nodiscard]] int test_point_in(const std::string& text);

/// Where the reference is on the model: of a point of the test (a node below
/// zero) its coordinates beside the nearest grid, or that grid where it lies.
/// @throws InputError where the test has no such point
[[nodiscard]] Location on_the_mesh(const EffectRef& ref,
                                   const effects::TestContext& context);

}  // namespace tapfit::updating
