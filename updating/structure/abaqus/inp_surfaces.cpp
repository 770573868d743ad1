// *SURFACE: of nodes, or of faces of elements.
#include "acquisition/foundation/trimmed_text.hpp"
#include "updating/structure/abaqus/inp_deck.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tapfit::structure {
namespace {

void add_nodes(const std::vector<int>& ids, InpSurface& surface) {
  surface.nodes.insert(surface.nodes.end(), ids.begin(), ids.end());
}

// S1 to S6; SPOS and SNEG of shells.
int face_number(const std::string& label, const Place& place) {
  const std::string name = upper(label);
  if (name == "SPOS" || name == "SNEG") return 1;
  const std::optional<int> face =
      name.starts_with("S") ? integer_of(name.substr(1)) : std::nullopt;
  if (!face) {
    fail_at(place,
            "the face has no label S1 to S6, SPOS or SNEG",
            "Give the element set and the label of the face.");
  }
  return *face;
}

void add_faces(const InpDeck& deck, const DataLine& line, InpSurface& surface) {
  const int number = face_number(line.text(1), line.place);
  for (const std::size_t k : deck.elements_of(line.text(0), line.place)) {
    const InpElement& e = deck.elements[k];
    if (e.type == nullptr) continue;
    if (e.type->family != InpFamily::Solid &&
        e.type->family != InpFamily::Shell &&
        e.type->family != InpFamily::Membrane) {
      add_nodes(e.nodes, surface);  // of beams, which have faces in CalculiX
      continue;
    }
    const std::vector<std::size_t> at = inp_face(*e.type, number);
    if (at.empty()) {
      fail_at(line.place,
              fmt::format("element {} ({}) has no face {}",
                          e.id,
                          e.type_name,
                          line.text(1)),
              "Correct the label of the face.");
    }
    std::vector<int> face;
    for (const std::size_t position : at) face.push_back(e.nodes[position]);
    const bool quadratic = e.type->nodes > e.type->corners;
    surface.corners.push_back(quadratic ? face.size() / 2 : face.size());
    surface.of_shells = surface.of_shells || e.type->family == InpFamily::Shell;
    add_nodes(face, surface);
    surface.faces.push_back(std::move(face));
  }
}

}  // namespace

void read_inp_surfaces(InpDeck& deck) {
  for (const Keyword* keyword : deck.of("SURFACE")) {
    InpSurface surface;
    const std::string type = keyword->option("TYPE");
    for (const DataLine& line : keyword->lines) {
      if (type == "NODE") {
        add_nodes(deck.nodes_of(line.text(0), line.place), surface);
      } else if (type.empty() || type == "ELEMENT") {
        // Without a label: the free faces, which only contact asks for.
        if (line.text(1).empty() || upper(line.text(1)).starts_with("E")) {
          for (const std::size_t k :
               deck.elements_of(line.text(0), line.place)) {
            add_nodes(deck.elements[k].nodes, surface);
          }
        } else {
          add_faces(deck, line, surface);
        }
      }
    }
    std::sort(surface.nodes.begin(), surface.nodes.end());
    surface.nodes.erase(std::unique(surface.nodes.begin(), surface.nodes.end()),
                        surface.nodes.end());
    deck.surfaces[keyword->needed_option("NAME")] = std::move(surface);
  }
}

}  // namespace tapfit::structure
