// What is dear in a reduced base, kept on disk from one run to the next: the
// modes of the whole model, its static responses at the measured points, and
// its matrices seen through them.
//
// The assembled matrices stand for the deck in the key: whatever card or
// element law changes them changes it. The program's own file stands for the
// method: another build works everything out anew.
#pragma once

#include "updating/cache/matrix_cache.hpp"
#include "updating/corrections/mass_forms.hpp"
#include "updating/properties/uncertain_parts.hpp"

#include <Eigen/Core>

#include <functional>
#include <optional>
#include <vector>

namespace tapfit::updating {

struct SolvedBase {
  Eigen::VectorXd modes_hz;
  Eigen::MatrixXd modes;                ///< n x count, supports rigid
  Eigen::MatrixXd V;                    ///< n x r, modes, static responses
  Eigen::MatrixXd K;                    ///< r x r, diagonal
  std::vector<Eigen::MatrixXd> K_part;  ///< one per uncertain part, r x r
  std::vector<Eigen::MatrixXd> M_part;
  double error = 0.0;  ///< see base_error()
};

/// What a solved base follows from.
struct BaseContent {
  const structure::System& system;
  const std::vector<MassForm>& forms;
  const std::vector<UncertainPart>& parts;
  const std::vector<int>& points;  ///< ascending
  Eigen::Index free = 0;           ///< degrees of freedom that move
  double high_hz = 0.0;
  double reach = 0.0;
};

/// What the cache has of this content, or what is solved for now and kept then.
///
/// @param cache empty: nothing is looked for and nothing kept
[[nodiscard]] SolvedBase kept_or_solved(
    const std::optional<MatrixCache>& cache,
    const BaseContent& content,
    const std::function<SolvedBase()>& solve);

}  // namespace tapfit::updating
