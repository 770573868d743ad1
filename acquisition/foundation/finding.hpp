// Something that is wrong with a test or may be: what was seen, what it likely
// is, and how test.json or the measurement is to be corrected.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace tapfit {

enum class Severity {
  Note,     ///< worth knowing; results hold
  Warning,  ///< some results are off by more than their stated uncertainty
  Error     ///< what follows means nothing until this is set right
};

/// "note", "warning", "error".
[[nodiscard]] std::string name(Severity severity);

/// The part of a test that a finding is about; empty: the whole.
struct Subject {
  std::vector<std::size_t> runs;   ///< ascending, from 0
  std::string channel;             ///< its name
  std::optional<std::size_t> hit;  ///< of the only run, from 0
  std::string point;               ///< "12Z+", or of an FRF "12Z+ / 3Z+"
};

/// "run 4, acc2, hit 3", "runs 4-6, 9, acc2 at 12Z+"; empty for the whole.
[[nodiscard]] std::string describe(const Subject& subject);

struct Finding {
  Severity severity = Severity::Warning;
  Subject where;
  std::string what;    ///< what was seen, and by how much
  std::string likely;  ///< what it likely is; may be empty
  std::string remedy;  ///< what to do, in test.json where that is enough
};

/// What and likely cause in one line, for lists without columns.
[[nodiscard]] std::string statement(const Finding& finding);

/// The same with the remedy.
[[nodiscard]] std::string in_full(const Finding& finding);

/// Moves `more` to the end of `all`.
void append(std::vector<Finding> more, std::vector<Finding>& all);

/// Errors first, then warnings, then notes; otherwise in their order.
void sort_by_severity(std::vector<Finding>& findings);

/// A number in so many digits without a power of ten: "3200", "0.0042".
[[nodiscard]] std::string in_digits(double value, int digits);

}  // namespace tapfit
