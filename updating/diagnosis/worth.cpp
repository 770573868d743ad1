#include "updating/diagnosis/worth.hpp"

#include "updating/diagnosis/diagnosis.hpp"
#include "updating/search/screened.hpp"

#include <algorithm>
#include <cmath>

namespace tapfit::updating {

const double very_strong = std::log(150.0);
const double at_floor = 1.3;
const double clear_of_floor = 3.0;

bool Worth::earned() const {
  return gain > very_strong && with_it < share * held_out;
}

bool is_at_floor(double error, const DiagnoseOptions& options) {
  return error <= at_floor * options.floor;
}

bool is_left_to_the_mesh(double error, const DiagnoseOptions& options) {
  return is_at_floor(error, options) &&
         error > clear_of_floor * options.floor_noise;
}

bool is_explained(double error, const DiagnoseOptions& options) {
  return is_at_floor(error, options) && !is_left_to_the_mesh(error, options);
}

bool is_unexplained(double error, double floor, double base, bool effects) {
  // FRFs of nothing at all have an error of 1: a base that is worse, for its
  // scale, lends no explanation to what is left.
  constexpr double nothing = 1.0;
  constexpr double part = 0.1;
  const double much = effects ? part * std::min(base, nothing) : 0.0;
  return error > std::max(clear_of_floor * floor, much);
}

double share_to_reach(double error, const DiagnoseOptions& options) {
  return is_at_floor(error, options) ? 1.0 / clear_of_floor : worth_it;
}

bool is_superfluous(double gain,
                    double error,
                    double without,
                    const DiagnoseOptions& options) {
  const bool alone =
      is_at_floor(without, options) && clear_of_floor * error > without;
  return gain < very_strong || alone;
}

}  // namespace tapfit::updating
