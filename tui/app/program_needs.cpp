// What the shown screens need, and what of it is there.
#include "tui/app/program.hpp"
#include "tui/views/diagnose_view.hpp"

#include <algorithm>

namespace tapfit::tui {

bool Program::lacks_input(const Page& page) const {
  if (!known_.bundle) return false;
  return (page.wants_model() && !known_.has_model) ||
         !page.nothing_here(*known_.bundle).empty();
}

bool Program::ready(const Page& page) const {
  if (lacks_input(page)) return false;
  const std::vector<Need> needs = page.essential();
  return known_.bundle &&
         std::all_of(needs.begin(), needs.end(), [&](const Need& need) {
           return known_.has(need) || page.can_wait_for(need, known_);
         });
}

std::optional<Need> Program::missing(const Page& page) const {
  for (const Need& need : page.essential()) {
    if (!known_.has(need)) return need;
  }
  return std::nullopt;
}

bool Program::is_wanted(const Need& need) const {
  return !known_.has(need) && !failed_.contains(need);
}

// What a screen cannot be drawn without goes first, for both of a split.
std::optional<Need> Program::need_of_screens() const {
  if (!known_.bundle) return std::nullopt;
  std::vector<const Page*> whole;
  for (const std::size_t screen : shown_screens()) {
    const Page& one = *pages_[screen];
    if (lacks_input(one)) continue;
    const std::optional<Need> need = missing(one);
    if (need && is_wanted(*need)) return need;
    if (!need) whole.push_back(&one);
  }
  // Commands name places of the model.
  const Need model{Stage::Model};
  if (mode_ == Mode::Colon && known_.has_model && !whole.empty() &&
      is_wanted(model)) {
    return model;
  }
  for (const Page* one : whole) {
    for (const Need& need : one->welcome(known_)) {
      if (is_wanted(need)) return need;
    }
  }
  return std::nullopt;
}

// What is missing from the deck is looked for as soon as the modes stand,
// whatever is shown.
std::optional<Need> Program::next_need() const {
  if (const auto need = need_of_screens()) return need;
  const bool begun = known_.bundle && known_.has_model && known_.modes;
  if (!begun || !known_.effects.empty()) return std::nullopt;
  const std::optional<Need> need = missing(*diagnose_page_);
  return need && is_wanted(*need) ? need : std::nullopt;
}

void Program::give_way_to_screens() {
  if (!running_ || running_need_ != Need{Stage::Diagnosis}) return;
  const std::optional<Need> need = need_of_screens();
  if (need && *need != *running_need_) worker_.stop();
}

bool Program::idle() const {
  return !running_ && actions_.empty() && !next_need();
}

}  // namespace tapfit::tui
