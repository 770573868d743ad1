// *NSET and *ELSET: ids, ranges (GENERATE) and names of other sets; *SURFACE:
// nodes, or faces of elements.
#include "updating/structure/abaqus/inp_deck.hpp"

#include <algorithm>
#include <set>

namespace tapfit::structure {
namespace {

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
  auto& sets = of_nodes ? deck.node_sets : deck.element_sets;
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
  if (of_nodes && keyword.has("ELSET")) {
    for (const std::size_t k : deck.element_set(keyword)) {
      const std::vector<int>& nodes = deck.elements[k].nodes;
      set.insert(set.end(), nodes.begin(), nodes.end());
    }
  }
  // Each once, in the order they are named in.
  std::set<int> seen;
  std::erase_if(set, [&seen](int id) { return !seen.insert(id).second; });
  sets[name] = std::move(set);
}

// S1 to S6; SPOS and SNEG of shells.
int face_number(const DataLine& line) {
  const std::string name = line.name(1);
  if (name == "SPOS" || name == "SNEG") return 1;
  const std::optional<int> face =
      name.starts_with("S") ? integer_of(name.substr(1)) : std::nullopt;
  if (!face) {
    fail_at(line.place,
            "the face has no label S1 to S6, SPOS or SNEG",
            "Give the element set and the label of the face.");
  }
  return *face;
}

void add_faces(const InpDeck& deck, const DataLine& line, InpSurface& surface) {
  // Without a label: the free faces, which only contact asks for.
  const std::string label = line.name(1);
  const bool all = label.empty() || label.starts_with("E");
  const int number = all ? 0 : face_number(line);
  for (const std::size_t k : deck.elements_of(line.text(0), line.place)) {
    const InpElement& e = deck.elements[k];
    if (e.type == nullptr) continue;
    const bool has_faces = e.is(InpFamily::Solid) || e.is(InpFamily::Shell) ||
                           e.is(InpFamily::Membrane);
    std::vector<int> face;
    if (!all && has_faces) {
      for (const std::size_t at : inp_face(*e.type, number)) {
        face.push_back(e.nodes[at]);
      }
      if (face.empty()) {
        fail_at(line.place,
                fmt::format("element {} ({}) has no face {}",
                            e.id,
                            e.type_name,
                            shortened(label)),
                "Correct the label of the face.");
      }
      surface.faces.push_back(face);
    } else {
      face = e.nodes;  // beams have faces in CalculiX, too
    }
    surface.nodes.insert(surface.nodes.end(), face.begin(), face.end());
  }
}

}  // namespace

void read_inp_sets(InpDeck& deck) {
  for (const Keyword& keyword : deck.keywords) {
    if (keyword.step > deck.last_step) continue;
    if (keyword.name == "NSET") read_set(deck, keyword, true);
    if (keyword.name == "ELSET") read_set(deck, keyword, false);
  }
}

void read_inp_surfaces(InpDeck& deck) {
  for (const Keyword* keyword : deck.of("SURFACE")) {
    InpSurface surface;
    const std::string type = keyword->option("TYPE");
    for (const DataLine& line : keyword->lines) {
      if (type == "NODE") {
        read_ids(deck, {{line.text(0)}, line.place}, true, surface.nodes);
      } else if (type.empty() || type == "ELEMENT") {
        add_faces(deck, line, surface);
      }
    }
    std::ranges::sort(surface.nodes);
    const auto tail = std::ranges::unique(surface.nodes);
    surface.nodes.erase(tail.begin(), tail.end());
    deck.surfaces[keyword->needed_option("NAME")] = std::move(surface);
  }
}

}  // namespace tapfit::structure
