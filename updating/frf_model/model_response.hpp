// What a model answers at the pairs of points that were measured.
#pragma once

#include "acquisition/foundation/dof.hpp"

#include <Eigen/Core>

#include <cstddef>
#include <string>
#include <vector>

namespace tapfit::updating {

struct ModelResponse {
  Eigen::MatrixXcd H;                ///< lines x pairs, accelerance
  std::vector<Eigen::MatrixXcd> dH;  ///< per entry of pack(); may be empty
};

/// Where the response of an FRF is felt, and where the force acts.
struct PairEnds {
  Dof response;
  Dof reference;

  bool operator==(const PairEnds&) const = default;
};

/// What was measured between two points, and under which names.
struct MeasuredPair {
  std::size_t run = 0;
  std::string channel;
  std::string hammer;
  PairEnds written;  ///< as the sheet has them
};

/// A pair of the FRF set and its columns among the points walked.
struct WalkedPair {
  Eigen::Index frf = 0;
  Eigen::Index response = 0;
  Eigen::Index reference = 0;
};

}  // namespace tapfit::updating
