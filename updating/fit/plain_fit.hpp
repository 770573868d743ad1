// The paper's plain updating (eq. 27) as a fit of the session: of uncertain
// properties and effects together, on lines that the engineer chose.
//
// The damping is not fitted but taken from the measured modes, and no prior
// holds the parameters; Tikhonov's lambda does. Errors are those on the
// comparison's damped line, so that fits of either kind can be compared. A
// state that is worse there than the start is not handed on. A fit that ends
// above the one before it is made once more from that one's properties, and
// gives way to it where that does no better.
#pragma once

#include "updating/fit/fit_problem.hpp"
#include "updating/fit/fitter.hpp"
#include "updating/fit/plain_updater.hpp"
#include "updating/fit/update_choice.hpp"

#include <string>
#include <vector>

namespace tapfit::updating {

/// What plain fits of one test share.
struct PlainTask {
  Target target;      ///< measured FRFs on the lines chosen
  std::string lines;  ///< which, in words
  PlainOptions options;
  /// Damping ratios of the lowest modes as measured, in order of frequency;
  /// further ones have the typical one.
  Eigen::VectorXd damping_ratio = {};
};

/// The line that errors are reported on, and the FRFs' own.
struct KnownLines {
  const Target& report;
  const std::string& contour;  ///< the first in words
  double sigma = 0.0;          ///< of the FRFs' exponential window [1/s]
};

/// @throws InputError where no line lies in the band, or a rule has no
///   resonance to go by
[[nodiscard]] PlainTask plain_task(const UpdateChoice& choice,
                                   const MeasuredTest& test,
                                   const KnownLines& known,
                                   const Progress& progress);

/// @param start, model as of Fitter::fit
/// @param before a fit, of either kind, of the first of these effects or of all
[[nodiscard]] Fit plain_fit(const Fitter& fitter,
                            const PlainTask& task,
                            const std::vector<EffectInstance>& start,
                            std::shared_ptr<const FrfModel> model,
                            const Fit& before);

}  // namespace tapfit::updating
