#include "tui/app/place_words.hpp"

#include "updating/set_up/sheet_place.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace tapfit::tui {
namespace {

using effects::Effect;
using effects::TestContext;
using updating::ChangeKind;

std::vector<std::string> grid_ids(const TestContext& context) {
  std::vector<std::string> ids;
  for (const auto& grid : context.deck->grids) {
    if (grid.id > 0) ids.push_back(std::to_string(grid.id));
  }
  return ids;
}

std::vector<std::string> element_ids(const TestContext& context) {
  std::vector<std::string> ids;
  for (const auto& shell : context.deck->shells) {
    ids.push_back(std::to_string(shell.id));
  }
  for (const auto& bar : context.deck->bars) {
    ids.push_back(std::to_string(bar.id));
  }
  return ids;
}

/// Those of the catalogue, each with the forms that it may take there.
std::vector<std::string> catalogue_places(const Effect& effect,
                                          const TestContext& context) {
  std::vector<std::string> words;
  for (const updating::Location& where : effect.places(context)) {
    if (effect.at_sheet_points()) {
      // The grid where it was comes before the runs, and is typed first.
      if (effect.takes_any_grid() && !where.runs.empty()) continue;
      words.push_back(effects::sheet_place_text(where));
      continue;
    }
    std::string word = where.node != 0
                           ? std::to_string(where.node)
                           : fmt::format("{}", fmt::join(where.channels, ":"));
    if (!where.variant.empty()) word += ":" + where.variant;
    words.push_back(word);
    for (const std::string& form : effect.forms()) {
      if (effect.takes(form, where, context))
        words.push_back(word + ":" + form);
    }
  }
  return words;
}

std::vector<std::string> all_words(const Effect& effect,
                                   const TestContext& context) {
  const std::optional<ChangeKind> kind = effect.changes_stiffness();
  if (kind == ChangeKind::Support) {
    std::vector<std::string> words = effect.variants();
    if (!words.empty()) return words;
    words = effect.forms();
    words.insert(words.begin(), {"rotation", "translation"});
    return words;
  }
  const bool of_channels = effect.entry() == effects::Entry::Measurement;
  if (context.deck == nullptr && !of_channels) return {};
  if (effect.corrects_deck()) return effect.variants();
  if (effect.sits() == effects::Sits::OnElements) return element_ids(context);
  if (kind == ChangeKind::Joint) return grid_ids(context);
  return catalogue_places(effect, context);
}

}  // namespace

std::vector<std::string> place_words(const Effect& effect,
                                     const TestContext& context,
                                     std::string_view typed) {
  // Elements and a joint's grids are given one after the other.
  const bool listed = effect.changes_stiffness().has_value();
  const std::size_t last = listed ? typed.find_last_of(":,") + 1 : 0;
  const std::string_view before = typed.substr(0, last);
  const std::string_view begun = typed.substr(last);
  std::vector<std::string> words;
  for (const std::string& word : all_words(effect, context)) {
    if (word.starts_with(begun)) words.push_back(std::string(before) + word);
  }
  return words;
}

}  // namespace tapfit::tui
