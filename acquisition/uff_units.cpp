#include "acquisition/uff_units.hpp"

#include "acquisition/input_error.hpp"

namespace tapfit::acquisition {

UffUnits read_uff_units(const UffDataset& dataset) {
  std::vector<double> values;
  if (dataset.lines.size() < 2 || !numbers(dataset.lines[1], 25, values) ||
      values.size() < 2 || !(values[0] > 0.0) || !(values[1] > 0.0)) {
    throw InputError("dataset 164 holds no unit factors",
                     dataset.place,
                     "check its second line");
  }
  return {values[0], values[1]};
}

}  // namespace tapfit::acquisition
