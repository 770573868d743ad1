#include "tui/report/before_after.hpp"

#include <fmt/format.h>

#include <map>

namespace tapfit::tui {

namespace {

using PairOf = std::map<int, updating::ModePair>;

PairOf by_measured_mode(const updating::Comparison& comparison) {
  PairOf pairs;
  for (const auto& pair : comparison.pairs) pairs[pair.measured] = pair;
  return pairs;
}

std::string model_cells(const PairOf& pairs, int mode) {
  const auto found = pairs.find(mode);
  if (found == pairs.end()) return " - | - | - |";
  const updating::ModePair& pair = found->second;
  return fmt::format(" {:.3f} | {:+.2f} | {:.3f} |",
                     pair.model_hz,
                     pair.error_percent,
                     pair.mac);
}

}  // namespace

std::string before_after_table(const updating::Comparison& before,
                               const updating::Comparison& after) {
  const PairOf old_pairs = by_measured_mode(before);
  const PairOf new_pairs = by_measured_mode(after);
  std::map<int, double> measured;
  for (const auto& [mode, pair] : old_pairs) measured[mode] = pair.measured_hz;
  for (const auto& [mode, pair] : new_pairs) measured[mode] = pair.measured_hz;

  std::string text =
      "| mode | measured Hz | before Hz | error % | MAC | after Hz | error % "
      "| MAC |\n|---|---|---|---|---|---|---|---|\n";
  for (const auto& [mode, hz] : measured) {
    text += fmt::format("| {} | {:.3f} |", mode + 1, hz) +
            model_cells(old_pairs, mode) + model_cells(new_pairs, mode) + "\n";
  }
  return text;
}

}  // namespace tapfit::tui
