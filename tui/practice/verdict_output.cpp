#include "tui/practice/verdict_output.hpp"

#include "tui/report/text_table.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace tapfit::tui {
namespace {

const char* right_or_wrong(bool right) { return right ? "right" : "wrong"; }

std::string effect_word(const updating::DiagnosisScore& verdict) {
  if (verdict.right_kind) return "right";
  return verdict.honest ? "true, but says less" : "wrong";
}

std::string size_word(const updating::DiagnosisScore& verdict) {
  if (verdict.intervals == 0) return verdict.right_size ? "right" : "not told";
  return fmt::format("{}, {} off",
                     right_or_wrong(verdict.right_size),
                     percent(verdict.size_error));
}

}  // namespace

nlohmann::ordered_json verdict_json(const updating::DiagnosisScore& verdict) {
  return {{"hidden", verdict.hidden},
          {"found", verdict.found},
          {"right_kind", verdict.right_kind},
          {"honest", verdict.honest},
          {"right_place", verdict.right_place},
          {"right_size", verdict.right_size},
          {"size_error", verdict.size_error},
          {"error", verdict.error},
          {"floor", verdict.floor},
          {"intervals", verdict.intervals},
          {"intervals_hold", verdict.intervals_hold}};
}

std::vector<std::string> verdict_row(const updating::DiagnosisScore& verdict) {
  const bool placed = verdict.right_kind && verdict.hidden != "none";
  return {effect_word(verdict),
          placed ? right_or_wrong(verdict.right_place) : "-",
          placed ? size_word(verdict) : "-",
          percent(verdict.error),
          percent(verdict.floor)};
}

}  // namespace tapfit::tui
