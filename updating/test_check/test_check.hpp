// The room updating/test_check. What is wrong with a test, told from the
// measurement before any model: the one list that `tapfit check` prints and the
// Recording screen shows.
// In:  A session.
// Out: TestCheck: findings, and the numbers that they rest on.
// May include: its row in CONTRIBUTING.md.
//
// Records first, then hits, FRFs and modes: each stage is looked at as far as
// the input lets it come.
#pragma once

#include "acquisition/checks/channel_record.hpp"
#include "acquisition/foundation/finding.hpp"
#include "acquisition/foundation/progress.hpp"
#include "signal/checks/frf_checks.hpp"
#include "signal/checks/hit_coherence.hpp"
#include "updating/session/session.hpp"

#include <optional>
#include <vector>

namespace tapfit::updating {

struct TestCheck {
  std::vector<acquisition::ChannelRecord> records;  ///< none for ready FRFs
  std::vector<signal::RunCoherence> coherence;      ///< per run
  std::vector<std::vector<std::size_t>> apart;      ///< hits, per run
  std::vector<signal::DrivingPoint> points;
  std::vector<signal::Reciprocal> pairs;
  std::size_t placed = 0;         ///< points of the test's own, on the model
  std::vector<Finding> findings;  ///< errors first

  /// Whether a diagnosis means anything.
  [[nodiscard]] bool may_go_on() const;
};

/// @param session best opened with Unreadable::LeftOut: one bad run then does
///   not hide what is wrong with the others
/// @param body_kg mass of the freely hung body with its sensors, where known;
///   else that of `weighed` and of the deck count
/// @throws Stopped; an InputError of a stage becomes a finding
[[nodiscard]] TestCheck check_test(Session& session,
                                   std::optional<double> body_kg,
                                   const Progress& progress);

}  // namespace tapfit::updating
