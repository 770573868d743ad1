// *PART, *INSTANCE, *ASSEMBLY: read where there is one part with one instance
// that is where the part is. Nodes and elements of the assembly itself
// (reference points) get ids above those of the part.
//
// Source: Abaqus Analysis User's Guide, "Defining an assembly".
#include "updating/structure/abaqus/inp_deck.hpp"

#include <algorithm>

namespace tapfit::structure {
namespace {

[[noreturn]] void refuse_assembly(const Keyword& keyword,
                                  const std::string& what) {
  keyword.fail(what,
               "Write the deck flat, without parts and assemblies (in "
               "Abaqus/CAE: the model attribute \"Do not use parts and "
               "assemblies in input files\").");
}

void refuse_moved(const Keyword& instance) {
  for (const DataLine& line : instance.lines) {
    for (std::size_t k = 0; k < line.fields.size(); ++k) {
      if (number_or(line, k, 0.0, "move") != 0.0) {
        refuse_assembly(instance, "the instance is moved or turned");
      }
    }
  }
}

void refuse_second(const std::vector<Keyword>& keywords,
                   const std::string& name) {
  bool seen = false;
  for (const Keyword& keyword : keywords) {
    if (keyword.name != name) continue;
    if (seen) refuse_assembly(keyword, "the deck has more than one of these");
    seen = true;
  }
}

// The largest first field of keywords of a name.
int largest_id(const std::vector<Keyword>& keywords, const std::string& name) {
  int largest = 0;
  for (const Keyword& keyword : keywords) {
    if (keyword.name != name) continue;
    for (const DataLine& line : keyword.lines) {
      largest = std::max(largest, integer_of(line.text(0)).value_or(0));
    }
  }
  return largest;
}

void raise(std::string& field, int by) {
  const std::optional<int> id = integer_of(field);
  if (id && by <= largest_inp_id && *id <= largest_inp_id - by) {
    field = fmt::format("{}", *id + by);
  }
}

struct Raised {
  int nodes = 0;
  int elements = 0;
};

// Only the third field of a range is a step.
void raise_ids(Keyword& keyword, const Raised& by) {
  const bool node = keyword.name == "NODE";
  const bool nset = keyword.name == "NSET";
  const bool element = keyword.name == "ELEMENT";
  if (!node && !nset && !element && keyword.name != "ELSET") return;
  if (keyword.has("INSTANCE")) return;
  for (DataLine& line : keyword.lines) {
    for (std::size_t k = 0; k < line.fields.size(); ++k) {
      if (node && k > 0) break;
      if (keyword.has("GENERATE") && k > 1) break;
      const bool of_node = node || nset || (element && k > 0);
      raise(line.fields[k], of_node ? by.nodes : by.elements);
    }
  }
}

}  // namespace

void flatten_assembly(InpDeck& deck) {
  refuse_second(deck.keywords, "PART");
  refuse_second(deck.keywords, "INSTANCE");
  Raised by;
  for (const Keyword& keyword : deck.keywords) {
    if (keyword.name == "INSTANCE") refuse_moved(keyword);
    if (keyword.name == "ASSEMBLY") {
      by = {largest_id(deck.keywords, "NODE"),
            largest_id(deck.keywords, "ELEMENT")};
    }
  }
  bool in_assembly = false;
  bool in_instance = false;
  for (Keyword& keyword : deck.keywords) {
    if (keyword.name == "ASSEMBLY") in_assembly = true;
    if (keyword.name == "ENDASSEMBLY") in_assembly = false;
    if (keyword.name == "INSTANCE") in_instance = true;
    if (keyword.name == "ENDINSTANCE") in_instance = false;
    if (in_assembly && !in_instance) raise_ids(keyword, by);
  }
}

}  // namespace tapfit::structure
