// What was identified, as rows of a table: the last model's parameters only,
// beside what the deck and the sensors' sheets say.
#pragma once

#include "tui/report/report_data.hpp"

#include <string>
#include <vector>

namespace tapfit::tui {

struct IdentifiedRow {
  std::string what;      ///< "E (MAT1 1)", "mass of the sensors (acc1, acc2)";
                         ///< empty where it is that of the row above
  std::string quantity;  ///< "mass", "Young's modulus"
  std::string value;     ///< with its unit and standard deviation
  std::string interval;  ///< 95 %
  std::string nominal;   ///< of the deck or sheet; "–" where there is none
  std::string change;    ///< against that, in per cent
};

/// "−1.88 %", of an uncertain property against the deck; empty of what is none
/// or is not determined.
[[nodiscard]] std::string change_words(const acquisition::TestBundle& bundle,
                                       const structure::Deck& deck,
                                       const updating::Estimate& estimate);

[[nodiscard]] std::vector<IdentifiedRow> identified_rows(
    const acquisition::TestBundle& bundle, const ModelResults& model);

}  // namespace tapfit::tui
