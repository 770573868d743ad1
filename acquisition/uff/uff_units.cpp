#include "acquisition/uff/uff_units.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/utf8.hpp"

#include <fmt/format.h>

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

bool is_unlabelled(std::string_view label) {
  return label.empty() || label == "NONE" || label == "None" || label == "none";
}

std::optional<double> uff_unit_to_si(std::string_view label,
                                     Quantity quantity,
                                     const UffUnits& units) {
  if (is_unlabelled(label)) {
    return 1.0 / (quantity == Quantity::Force ? units.force : units.length);
  }
  const std::optional<Unit> unit = find_unit(label);
  if (!unit || unit->quantity != quantity) return std::nullopt;
  return unit->si;
}

std::string no_uff_unit(std::string_view label, Quantity quantity) {
  return fmt::format("its label \"{}\" is no known unit of {}; known are {}",
                     as_utf8(label),
                     name(quantity),
                     known_units(quantity));
}

}  // namespace tapfit::acquisition
