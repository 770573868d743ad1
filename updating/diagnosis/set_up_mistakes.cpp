#include "updating/diagnosis/set_up_mistakes.hpp"

#include "updating/catalogue/catalogue.hpp"
#include "updating/set_up/sheet_edits.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace tapfit::updating {

std::vector<SetUpMistake> set_up_mistakes(
    const std::vector<Rung>& ladder, const acquisition::TestBundle& sheet) {
  std::vector<SetUpMistake> result;
  acquisition::TestBundle corrected = sheet;
  for (const Rung& rung : ladder) {
    const std::string kind = leading_kind(rung);
    const effects::Effect& effect = effects::find(kind);
    if (!effect.is_mistake()) continue;
    std::vector<std::string> edits =
        effects::sheet_edits(effect, rung.where, sheet, corrected);
    effect.correct(rung.where, sheet, corrected);
    if (edits.empty()) continue;
    result.push_back({kind,
                      rung.where,
                      rung.probability,
                      rung.error,
                      fmt::format("{}", fmt::join(edits, "; "))});
  }
  return result;
}

// ln p of one reading x by a normal density of sd x over that of sd u:
// (x / u)^2 / 2 - ln(x / u) - 1/2.
std::vector<SetUpMistake> run_outliers(
    const std::vector<modal::ForeignRun>& foreign,
    std::size_t runs,
    double error) {
  std::vector<SetUpMistake> result;
  for (const modal::ForeignRun& one : foreign) {
    const double times = one.left / std::max(one.usual, 1e-12);
    const double gain = 0.5 * times * times - std::log(times) - 0.5 -
                        std::log(static_cast<double>(runs));
    Location where;
    where.runs = {static_cast<int>(one.run) + 1};
    result.push_back(
        {"run-outlier",
         std::move(where),
         1.0 / (1.0 + std::exp(-gain)),
         error,
         fmt::format("runs[{0}].file, or take runs[{0}] out", one.run)});
  }
  return result;
}

std::string describe(const SetUpMistake& mistake) {
  return fmt::format("{}: correct {}",
                     effect_text(mistake.mistake, mistake.where),
                     mistake.edit);
}

}  // namespace tapfit::updating
