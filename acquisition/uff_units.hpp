// Dataset 164 of a universal file: the units its numbers are in.
#pragma once

#include "acquisition/uff_datasets.hpp"

namespace tapfit::acquisition {

/// A value in file units divided by these is in SI.
struct UffUnits {
  double length = 1.0;
  double force = 1.0;
};

/// @throws InputError for a dataset 164 without factors above zero
[[nodiscard]] UffUnits read_uff_units(const UffDataset& dataset);

}  // namespace tapfit::acquisition
