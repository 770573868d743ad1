// The frequency lines that an engineer asks an updating to use, as words:
//
//   damped                       s = sigma + j omega, from wide to narrow
//   rule[:GAP]                   even lines, but for the gaps of section 2.3
//   even[:STEP]                  Case 1 of section 4.1.3
//   random[:COUNT]               Case 2
//   before-peaks[:BEFORE[:STEP[:COUNT]]]   Case 3
//   20,31.5,40:60:0.5            these and no others
//
// All in Hz. Where a size is left out it is the paper's for its truss (gap 4
// Hz, 8 lines 0.5 Hz apart from 10 Hz before a peak), in proportion to the
// first resonance (75.7 Hz there).
// Source: "Model Updating Using Frequency Response Functions Based on
// Sherman-Morrison Formula", sections 2.3 and 4.1.3.
#pragma once

#include "updating/residual/line_choice.hpp"

#include <Eigen/Core>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace tapfit::updating {

enum class LineKind { Damped, Rule, Even, Random, BeforePeaks, List };

struct LineRule {
  LineKind kind = LineKind::Damped;
  std::string text = "damped";
  std::vector<double> sizes;  ///< as written; of a list its lines, ascending
};

/// @throws InputError for anything but the words above, sizes that are not
///   positive and lists of more than 10,000 lines
[[nodiscard]] LineRule parse_lines(const std::string& text);

/// Lines inside the band [Hz], ascending, for any rule but the damped one.
///
/// @param resonances_hz measured, ascending
/// @throws InputError where none is left, or a rule needs resonances and there
///   are none
[[nodiscard]] Eigen::VectorXd lines_of(const LineRule& rule,
                                       std::array<double, 2> band_hz,
                                       const Eigen::VectorXd& resonances_hz);

/// Refuses what lines_of() would refuse whatever is measured, before anything
/// is.
/// @throws InputError
void check_lines(const LineRule& rule, std::array<double, 2> band_hz);

/// The gaps around resonances; empty but for the rule of section 2.3.
[[nodiscard]] std::optional<PeakRule> gaps_of(
    const LineRule& rule, const Eigen::VectorXd& resonances_hz);

}  // namespace tapfit::updating
