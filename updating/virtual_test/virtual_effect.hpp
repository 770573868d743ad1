// What is hidden in a virtual structure or its measuring chain, as written on
// a command line: NAME[@PLACE[:PLACE...]][=VALUE[,VALUE...]], for example
// "added-mass@201=0.05", "channel-gain@acc2=1.1", "absorber@44=0.05,31,0.01".
// A support has a form in place of a place: "soft-support@both=3000,1e6".
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace tapfit::updating {

struct VirtualEffect {
  std::string name;                 ///< as in the result format
  std::vector<std::string> places;  ///< grids, elements or channels
  std::vector<double> values;       ///< SI, in the order of the catalogue
  std::string form = {};  ///< of a support: "translation", "both"; else it
                          ///< turns

  /// Places as numbers (grids, elements).
  [[nodiscard]] std::vector<int> numbers() const;

  bool operator==(const VirtualEffect&) const = default;
};

/// @throws InputError for an unknown name, a missing or superfluous place or
///   value, a value that is no number
[[nodiscard]] VirtualEffect parse_virtual_effect(const std::string& text);

/// The effect as parse_virtual_effect() reads it, every digit kept.
[[nodiscard]] std::string virtual_effect_text(const VirtualEffect& effect);

/// One line per effect: how it is written and the unit of each value.
[[nodiscard]] std::string virtual_effect_help();

/// The entry of truth.json: `effect`, its place and its parameters.
///
/// @param channels those meant when an effect of the sensors names none
[[nodiscard]] nlohmann::ordered_json truth_entry(
    const VirtualEffect& effect, const std::vector<std::string>& channels);

}  // namespace tapfit::updating
