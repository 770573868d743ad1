// Whether the check of a test names a mistake, and what else it says.
#pragma once

#include "tests/acquisition/support/temporary_folder.hpp"
#include "tests/updating/support/test_mistakes.hpp"
#include "updating/test_check/test_check.hpp"

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

namespace tapfit::updating::testing {

inline TestCheck check_of(const SheetAndRecords& test) {
  const tapfit::testing::TemporaryFolder folder;
  write_bundle(test, folder.path() / "test");
  Session session(folder.path() / "test", acquisition::Unreadable::LeftOut);
  return check_test(session, {}, {});
}

/// Findings that are no notes, a line each.
inline std::string serious(const std::vector<Finding>& findings) {
  std::string text;
  for (const Finding& f : findings) {
    if (f.severity == Severity::Note) continue;
    text +=
        name(f.severity) + " " + describe(f.where) + ": " + in_full(f) + "\n";
  }
  return text;
}

inline bool is_named(const Mistake& mistake,
                     const std::vector<Finding>& findings) {
  const auto holds = [](const Finding& f, const std::string& alternatives) {
    std::istringstream words(alternatives);
    for (std::string word; std::getline(words, word, '|');) {
      if (in_full(f).find(word) != std::string::npos) return true;
    }
    return false;
  };
  return std::ranges::any_of(findings, [&](const Finding& f) {
    return f.severity != Severity::Note &&
           std::ranges::all_of(mistake.words, [&](const std::string& word) {
             return holds(f, word);
           });
  });
}

}  // namespace tapfit::updating::testing
