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
#include "updating/comparison/comparison.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace tapfit::updating {

/// What was found of one measured mode, or the worst of several. What is not
/// known is absent.
struct Criteria {
  bool paired = false;
  std::optional<double> frequency_percent;  ///< 0 or more
  std::optional<double> mac;
  std::optional<double> on_diagonal;   ///< cross-orthogonality of the pair
  std::optional<double> off_diagonal;  ///< largest with another pair's mode
};

/// One of them: where its value and its limit stand.
struct Criterion {
  std::optional<double> Criteria::*found;
  std::optional<double> acquisition::Limits::*limit;
  bool at_least;  ///< otherwise at most
};
inline constexpr std::array<Criterion, 4> criteria{
    {{&Criteria::frequency_percent,
      &acquisition::Limits::frequency_percent,
      false},
     {&Criteria::mac, &acquisition::Limits::mac, true},
     {&Criteria::on_diagonal,
      &acquisition::Limits::cross_orthogonality_diagonal,
      true},
     {&Criteria::off_diagonal,
      &acquisition::Limits::cross_orthogonality,
      false}}};

/// @param measured_modes how many; those without a pair are among them
[[nodiscard]] std::vector<Criteria> criteria_of(const Comparison& comparison,
                                                std::size_t measured_modes);

/// The worst of those that are paired.
/// @return `paired` where all are
[[nodiscard]] Criteria worst_of(const std::vector<Criteria>& modes);

/// Whether any limit is set.
[[nodiscard]] bool any_limit(const acquisition::Limits& limits);

/// Whether one limit is kept.
/// @return nothing where it is not set, or there is no value
[[nodiscard]] std::optional<bool> keeps_one(const Criterion& one,
                                            const Criteria& mode,
                                            const acquisition::Limits& limits);

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

}  // namespace tapfit::updating
