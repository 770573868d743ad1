// The units that a universal file's numbers are in: those of a function's axis
// labels; without a label those of dataset 164; without that SI.
#pragma once

#include "acquisition/foundation/units.hpp"
#include "acquisition/uff/uff_datasets.hpp"

#include <optional>
#include <string>

namespace tapfit::acquisition {

/// A value in file units divided by these is in SI.
struct UffUnits {
  double length = 1.0;
  double force = 1.0;
};

/// @throws InputError for a dataset 164 without factors above zero
[[nodiscard]] UffUnits read_uff_units(const UffDataset& dataset);

/// Whether an axis says no unit: an empty label or NONE.
[[nodiscard]] bool is_unlabelled(std::string_view label);

/// SI value of one unit of an axis: the label's, or that of dataset 164 where
/// the axis is unlabelled. Empty for a label that is no known unit of the
/// quantity: what its numbers are in cannot be guessed.
[[nodiscard]] std::optional<double> uff_unit_to_si(std::string_view label,
                                                   Quantity quantity,
                                                   const UffUnits& units);

/// Why a label gave no unit, with those that are known.
[[nodiscard]] std::string no_uff_unit(std::string_view label,
                                      Quantity quantity);

}  // namespace tapfit::acquisition
