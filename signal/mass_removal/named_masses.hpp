// Masses that load a test, by the names of sensors or points.
#pragma once

#include "acquisition/bundle/test_bundle.hpp"
#include "signal/mass_removal/sensor_loads.hpp"

#include <optional>
#include <string>
#include <vector>

namespace tapfit::signal {

/// One --free as written: CHANNEL or POINT, [=KG][,sd=KG].
struct FreeWord {
  std::string what;
  std::optional<double> kg;
  double sd_kg = 0.0;
};

/// @return empty when the text is none
[[nodiscard]] std::optional<FreeWord> parse_free(const std::string& text);

/// The masses that words name, where they sit. "all" is every channel whose
/// mass the bundle states; a channel without a mass has the bundle's; a point
/// ("12Z=0.02") is a mass that stays there in all runs.
///
/// @throws InputError for a name that is none, a mass that is not known, words
///   that mix channels and points
[[nodiscard]] LoadedTest masses_to_free(const acquisition::TestBundle& bundle,
                                        const FrfSet& frfs,
                                        const std::vector<std::string>& words);

}  // namespace tapfit::signal
