// Mode shapes and other data at nodes: datasets 55 and 2414 of a universal
// file.
//
//   55    5 ID lines / 6I10 / 8I10 / 6E13.5 / (I10 / 6E13.5) per node
//   2414  label, name, place / 5 ID lines / 6I10 / 10 integers / 12 reals /
//         (I10 / 6E13.5) per node
//
// Normal mode (analysis type 2): frequency [Hz], modal mass, viscous and
// hysteretic damping (zeta = eta / 2 where only that is given). Complex mode
// (3, 7): the eigenvalue [rad/s] and modal A: f = |lambda| / 2 pi,
// zeta = -Re lambda / |lambda|.
//
// Source: SDRC universal file formats, as kept by the University of
// Cincinnati.
#pragma once

#include "acquisition/uff/uff_datasets.hpp"

#include <Eigen/Core>

#include <array>
#include <complex>
#include <map>
#include <string>

namespace tapfit::acquisition {

struct UffShape {
  int analysis = 0;   ///< 1 static, 2 normal mode, 3 and 7 complex modes, ..
  int data_type = 0;  ///< 8 displacement, 11 velocity, 12 acceleration
  bool complex = false;
  int mode = 0;  ///< number, 0 where none is given
  double frequency_hz = 0.0;
  double damping_ratio = 0.0;
  double modal_mass = 0.0;
  std::complex<double> eigenvalue;  ///< of a complex mode [rad/s]; 0: not given
  std::complex<double> modal_a;     ///< of a complex mode; 0: not given
  std::array<std::string, 5> id;
  std::map<int, Eigen::VectorXcd> values;  ///< per node, as the file has them
};

/// Whether a dataset 55 or 2414 holds values at nodes and not at elements.
/// @throws InputError for a dataset that ends before it says so
[[nodiscard]] bool stands_at_nodes(const UffDataset& dataset);

/// Reads a dataset 55 or 2414.
///
/// @throws InputError with the line for text that is no number, a dataset that
///   ends within an entry, data that does not stand at nodes
[[nodiscard]] UffShape read_shape(const UffDataset& dataset);

}  // namespace tapfit::acquisition
