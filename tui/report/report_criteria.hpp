// The criteria of correlation: each measured mode against the model's mode that
// is paired with it, and whether the limits of the test are kept.
//
//   frequency error      |f_model - f_measured| / f_measured
//   MAC                  |m' a|² / (m' m · a' a)
//   cross-orthogonality  |m' M a| / sqrt(m' M m · a' M a)
//
// with m and a the measured and the model's shape and M the model's mass at the
// measured points. On the diagonal m and a are a pair, off it they are of two
// pairs. A measured mode without a pair keeps no limit.
//
// Source: D. J. Ewins, "Modal Testing", 2nd edition, 2000, chapter 5.
#pragma once

#include "acquisition/bundle/test_notes.hpp"
#include "tui/document/document.hpp"
#include "tui/report/report_data.hpp"

#include <optional>
#include <string>
#include <vector>

namespace tapfit::tui {

/// What was found of one measured mode, or the worst of several. What is not
/// known is absent.
struct Criteria {
  bool paired = false;
  std::optional<double> frequency_percent;  ///< 0 or more
  std::optional<double> mac;
  std::optional<double> on_diagonal;   ///< cross-orthogonality of the pair
  std::optional<double> off_diagonal;  ///< largest with another pair's mode
};

/// @param measured_modes how many; those without a pair are among them
[[nodiscard]] std::vector<Criteria> criteria_of(
    const updating::Comparison& comparison, std::size_t measured_modes);

/// The worst of those that are paired.
/// @return `paired` where all are
[[nodiscard]] Criteria worst_of(const std::vector<Criteria>& modes);

/// Whether any limit is set.
[[nodiscard]] bool any_limit(const acquisition::Limits& limits);

/// Whether the limits that are set are kept.
/// @return nothing where one has no value, as MAC of pairs without shapes, and
///   no other is broken
[[nodiscard]] std::optional<bool> keeps(const Criteria& mode,
                                        const acquisition::Limits& limits);

/// How many modes keep all limits that are set, and how many break one.
struct Tally {
  std::size_t kept = 0;
  std::size_t failed = 0;
  std::size_t modes = 0;  ///< those that could not be tested among them
  /// @return nothing where none fails and not all are tested
  [[nodiscard]] std::optional<bool> verdict() const;
};
[[nodiscard]] Tally tally(const std::vector<Criteria>& modes,
                          const acquisition::Limits& limits);

/// "The limits of the test (frequency within 5 %, MAC at least 0.9) are kept by
/// all 4 modes: pass. Before, 2 of 4 kept them."
/// @return empty where the test sets none or there is no model
[[nodiscard]] std::string criteria_sentence(const ReportData& data);

/// Each criterion at its worst before and after, and each mode before and
/// after. @param data with a model and at least one measured mode
[[nodiscard]] std::vector<Part> criteria_parts(const ReportData& data);

}  // namespace tapfit::tui
