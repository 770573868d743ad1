// Which FRFs form a complete matrix, outputs x references.
//
// With a roving hammer the fixed sensors are the references (by reciprocity the
// hit points are the outputs); with roving sensors the hammer is. Several
// references are what separates close modes.
#pragma once

#include "modal/poles/weighted_frfs.hpp"

#include <vector>

namespace tapfit::modal {

/// Complete rows of FRFs: every row has one FRF for each reference.
struct FrfMatrix {
  std::vector<std::vector<Eigen::Index>> rows;  ///< index into WeightedFrfs
  Eigen::Index references = 1;
};

/// Arranges the FRFs for poly-reference identification.
///
/// Repeated measurements are rows of their own, so that they need not agree.
/// Rows with a missing FRF are left out. Where hammer and sensors move so that
/// no two references are shared, all FRFs become outputs of one reference.
///
/// @param most_references more are not used; they cost time and add little
[[nodiscard]] FrfMatrix arrange_frfs(const WeightedFrfs& curves,
                                     Eigen::Index most_references = 4);

}  // namespace tapfit::modal
