// *NSET and *ELSET: ids, ranges (GENERATE) and names of other sets.
#include "updating/structure/abaqus/inp_deck.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tapfit::structure {
namespace {

using Sets = std::map<std::string, std::vector<int>>;

// GENERATE: first, last, step. Ids that are not there are left out.
template <typename Index>
void generate(const DataLine& line, const Index& known, std::vector<int>& set) {
  const int first = integer_in(line, 0, "first id");
  const int last =
      line.text(1).empty() ? first : integer_in(line, 1, "last id");
  const int step = line.text(2).empty() ? 1 : integer_in(line, 2, "step");
  if (first < 1 || step < 1 || last < first) {
    fail_at(line.place,
            fmt::format("{} to {} by {} names nothing", first, last, step),
            "Give the smaller id first; ids and steps are above zero.");
  }
  // Ranges may run far over what is there.
  if ((last - first) / step < 2 * static_cast<long>(known.size())) {
    for (long id = first; id <= last; id += step) {
      if (known.contains(static_cast<int>(id))) {
        set.push_back(static_cast<int>(id));
      }
    }
    return;
  }
  const std::size_t before = set.size();
  for (const auto& [id, place] : known) {
    if (id >= first && id <= last && (id - first) % step == 0) {
      set.push_back(id);
    }
  }
  std::sort(set.begin() + static_cast<std::ptrdiff_t>(before), set.end());
}

void read_ids(InpDeck& deck,
              const DataLine& line,
              bool of_nodes,
              std::vector<int>& set) {
  for (const std::string& field : line.fields) {
    if (field.empty()) continue;
    if (of_nodes) {
      const std::vector<int> ids = deck.nodes_of(field, line.place);
      set.insert(set.end(), ids.begin(), ids.end());
    } else {
      for (const std::size_t k : deck.elements_of(field, line.place)) {
        set.push_back(deck.elements[k].id);
      }
    }
  }
}

void read_set(InpDeck& deck, const Keyword& keyword, bool of_nodes) {
  const std::string name = keyword.needed_option(of_nodes ? "NSET" : "ELSET");
  Sets& sets = of_nodes ? deck.node_sets : deck.element_sets;
  std::vector<int> set = sets[name];
  for (const DataLine& line : keyword.lines) {
    if (!keyword.has("GENERATE")) {
      read_ids(deck, line, of_nodes, set);
    } else if (of_nodes) {
      generate(line, deck.node_index, set);
    } else {
      generate(line, deck.element_index, set);
    }
  }
  const std::string from = keyword.option("ELSET");
  if (of_nodes && !from.empty()) {
    for (const std::size_t k : deck.elements_of(from, keyword.place)) {
      const std::vector<int>& nodes = deck.elements[k].nodes;
      set.insert(set.end(), nodes.begin(), nodes.end());
    }
  }
  // Each once, in the order they are named in.
  std::set<int> seen;
  std::erase_if(set, [&seen](int id) { return !seen.insert(id).second; });
  sets[name] = std::move(set);
}

}  // namespace

void read_inp_sets(InpDeck& deck) {
  for (const Keyword& keyword : deck.keywords) {
    const bool used = keyword.step <= deck.last_step;
    if (!used) continue;
    if (keyword.name == "NSET") read_set(deck, keyword, true);
    if (keyword.name == "ELSET") read_set(deck, keyword, false);
  }
}

}  // namespace tapfit::structure
