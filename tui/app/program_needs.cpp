// What the shown screens need, and what of it is there.
#include "tui/app/program.hpp"

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

// What a screen cannot be drawn without goes first, for both of a split.
std::optional<Need> Program::next_need() const {
  if (!known_.bundle) return std::nullopt;
  const auto wanted = [this](const Need& need) {
    return !known_.has(need) && !failed_.contains(need);
  };
  std::vector<const Page*> whole;
  for (const std::size_t screen : shown_screens()) {
    const Page& one = *pages_[screen];
    if (lacks_input(one)) continue;
    const std::optional<Need> need = missing(one);
    if (need && wanted(*need)) return need;
    if (!need) whole.push_back(&one);
  }
  // Commands name places of the model.
  const Need model{Stage::Model};
  if (mode_ == Mode::Colon && known_.has_model && !whole.empty() &&
      wanted(model)) {
    return model;
  }
  for (const Page* one : whole) {
    for (const Need& need : one->welcome(known_)) {
      if (wanted(need)) return need;
    }
  }
  return std::nullopt;
}

bool Program::idle() const {
  return !running_ && actions_.empty() && !next_need();
}

}  // namespace tapfit::tui
