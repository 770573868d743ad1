// One function of a universal file: dataset 58, ASCII or binary, any of its
// six data layouts.
//
//   layout   even abscissa              uneven abscissa
//   single   6E13.5: y y y ...          6E13.5: x y x y ...
//   double   4E20.12                    E13.5,E20.12
//   complex  re im re im ...            x re im ...: 6E13.5 or E13.5,2E20.12
#pragma once

#include "acquisition/foundation/dof.hpp"
#include "acquisition/uff/uff_datasets.hpp"

#include <Eigen/Core>

#include <array>
#include <functional>
#include <optional>
#include <string>

namespace tapfit::acquisition {

/// What an axis is: specific data type and the unit's label.
struct UffAxis {
  int type = 0;  ///< 8 displacement, 11 velocity, 12 acceleration, 13 force, ..
  std::string unit;
};

/// What a function is, without its values.
struct UffHeader {
  int function_type = 0;         ///< 1 time, 4 FRF, 6 coherence, ...
  int number = 0;                ///< function identification number
  std::optional<Dof> response;   ///< empty: a scalar
  std::optional<Dof> reference;  ///< empty: a scalar
  std::array<std::string, 5> id;
  UffAxis abscissa;
  UffAxis numerator;
  UffAxis denominator;
  bool complex = false;
  bool is_double = false;
  bool even = true;  ///< abscissa is min + i step
  Eigen::Index count = 0;
  double min = 0.0;
  double step = 0.0;
};

struct UffFunction : UffHeader {
  Eigen::VectorXd x;   ///< abscissa, all values
  Eigen::VectorXcd y;  ///< ordinate, imaginary part 0 for real functions
};

/// Only what the function is (record 6), without its data.
[[nodiscard]] int function_type(const UffDataset& dataset);

/// Reads records 1 to 11 of dataset 58 or 58b.
///
/// @throws InputError for missing records, an unknown data type, a count that
///   the file cannot hold
[[nodiscard]] UffHeader read_header(const UffDataset& dataset);

/// The number behind a key in any of the ID lines, as "RATE = 51200 Hz".
[[nodiscard]] std::optional<double> number_in_id(
    const std::array<std::string, 5>& id, std::string_view key);

/// Reads dataset 58 or 58b.
///
/// @throws InputError for missing records, an unknown data type, fewer values
///   than announced, text that is no number
[[nodiscard]] UffFunction read_function(const UffDataset& dataset);

/// Goes through dataset 58 or 58b as read_function() does and keeps no value: a
/// record may be larger than memory.
///
/// @param passed told of each part of the data that was gone through
/// @throws InputError as of read_function()
[[nodiscard]] UffHeader check_function(
    const UffDataset& dataset,
    const std::function<void(std::string_view)>& passed = {});

}  // namespace tapfit::acquisition
