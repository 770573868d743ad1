#include "updating/diagnosis/set_up_mistakes.hpp"

#include "updating/catalogue/catalogue.hpp"
#include "updating/set_up/sheet_edits.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

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

std::string describe(const SetUpMistake& mistake) {
  return fmt::format("{}: correct {}",
                     effect_text(mistake.mistake, mistake.where),
                     mistake.edit);
}

}  // namespace tapfit::updating
