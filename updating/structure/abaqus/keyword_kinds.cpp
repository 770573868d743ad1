// Which keywords are read, and which the model lacks something without.
#include "updating/structure/abaqus/inp_deck.hpp"

#include <algorithm>
#include <set>
#include <sstream>

namespace tapfit::structure {
namespace {

using Names = std::set<std::string>;

// Words between blanks.
Names words(const char* text) {
  std::istringstream stream(text);
  Names names;
  for (std::string name; stream >> name;) names.insert(name);
  return names;
}

const Names& read_keywords() {
  static const Names names = words(
      "HEADING NODE ELEMENT NSET ELSET INCLUDE SURFACE TRANSFORM ORIENTATION "
      "PART ENDPART INSTANCE ENDINSTANCE ASSEMBLY ENDASSEMBLY PREPRINT "
      "MATERIAL ELASTIC DENSITY SOLIDSECTION SHELLSECTION SHELLGENERALSECTION "
      "MEMBRANESECTION NODALTHICKNESS BEAMSECTION BEAMGENERALSECTION "
      "MASS ROTARYINERTIA SPRING DASHPOT BOUNDARY EQUATION MPC RIGIDBODY "
      "KINEMATICCOUPLING COUPLING KINEMATIC DISTRIBUTING DISTRIBUTINGCOUPLING "
      "TIE "
      "STEP ENDSTEP STATIC FREQUENCY COMPLEXFREQUENCY");
  return names;
}

// Those that count in steps, too.
const Names& step_keywords() {
  static const Names names = words(
      "HEADING NSET ELSET PREPRINT BOUNDARY STEP ENDSTEP STATIC FREQUENCY "
      "COMPLEXFREQUENCY");
  return names;
}

// What the model lacks, and the keywords without which it does.
struct Lack {
  const char* consequence;
  Names names;
};

const std::vector<Lack>& lacks() {
  static const std::vector<Lack> all{
      {"what touches or is glued comes apart; join it by *TIE",
       words("CONTACTPAIR CONTACT CONTACTINCLUSIONS GAP COHESIVESECTION "
             "GASKETSECTION EMBEDDEDELEMENT SHELLTOSOLIDCOUPLING "
             "PRE-TENSIONSECTION")},
      {"a sector is not closed to the whole; write the whole model",
       words("CYCLICSYMMETRYMODEL PERIODIC")},
      {"elements or matrices are missing; write them as elements that are read",
       words("USERELEMENT MATRIXINPUT MATRIXASSEMBLE SUPERELEMENT "
             "SUBSTRUCTUREPROPERTY SUBSTRUCTUREGENERATE ELEMENTPROPERTIES "
             "FRAMESECTION REBAR REBARLAYER")},
      {"the material is not known; write *ELASTIC",
       words("USERMATERIAL HYPERELASTIC HYPERFOAM CHANGEMATERIAL")},
      {"joints or supports are missing; use springs, *MPC or *COUPLING",
       words("CONNECTORSECTION FASTENER JOINT ITS FOUNDATION RELEASE LINK "
             "INERTIARELIEF")},
      {"mass is missing; put it into the density or into *MASS",
       words("NONSTRUCTURALMASS BEAMADDEDINERTIA")},
      {"nodes or elements are missing or elsewhere; write them out",
       words("NGEN NFILL NCOPY NMAP SYSTEM ELGEN ELCOPY IMPORT IMPERFECTION "
             "MODELCHANGE")},
      {"the model's edges are driven by another one", words("SUBMODEL")},
      {"a section is another one; leave its stiffness to the program",
       words("TRANSVERSESHEARSTIFFNESS CHANGESOLIDSECTION")}};
  return all;
}

const Lack* lack_of(const std::string& name) {
  const auto found = std::ranges::find_if(
      lacks(), [&](const Lack& lack) { return lack.names.contains(name); });
  return found == lacks().end() ? nullptr : &*found;
}

bool solves_for_modes(const Keyword& keyword) {
  return keyword.name == "FREQUENCY" || keyword.name == "COMPLEXFREQUENCY";
}

bool is_load(const Keyword& keyword) {
  static const Names loads =
      words("CLOAD DLOAD DSLOAD TEMPERATURE BODYFORCE PRE-TENSIONSECTION");
  return loads.contains(keyword.name);
}

// The stiffness of a loaded state, which modes on top of it have: CalculiX
// takes it where their step is a perturbation, Abaqus where the loading one is
// of large displacements.
void leave_out_preload(InpDeck& deck) {
  const Keyword* statics = nullptr;
  bool loaded = false;
  bool large = false;
  for (const Keyword& keyword : deck.keywords) {
    if (keyword.step == 0 || keyword.step > deck.last_step) continue;
    if (keyword.step < deck.last_step) {
      if (keyword.name == "STATIC" && statics == nullptr) statics = &keyword;
      loaded = loaded || is_load(keyword);
      large = large || (keyword.name == "STEP" && keyword.has("NLGEOM") &&
                        keyword.option("NLGEOM") != "NO");
    } else if (keyword.name == "STEP") {
      large = large || keyword.has("PERTURBATION");
    }
  }
  if (statics == nullptr || !loaded || !large) return;
  deck.leave_out("STATIC",
                 statics->place,
                 "the stiffness of the load before the modes is missing from "
                 "the model, which is that without stress");
}

void warn_of_open_step(InpDeck& deck) {
  const Keyword* open = nullptr;
  for (const Keyword& keyword : deck.keywords) {
    if (keyword.name == "STEP") open = &keyword;
    if (keyword.name == "ENDSTEP") open = nullptr;
  }
  if (open == nullptr) return;
  deck.say(open->place.where +
           ": the step has no *END STEP; the deck may be cut off");
}

}  // namespace

void sort_keywords(InpDeck& deck) {
  const auto modes = std::ranges::find_if(deck.keywords, solves_for_modes);
  if (modes != deck.keywords.end()) deck.last_step = std::max(1, modes->step);
  Names others;
  for (const Keyword& keyword : deck.keywords) {
    // Those that name a file have been inlined.
    if (keyword.name == "INCLUDE") {
      keyword.fail("it names no file", "Write *INCLUDE, INPUT=file.");
    }
    if (const Lack* lack = lack_of(keyword.name)) {
      deck.leave_out(keyword.shown, keyword.place, lack->consequence);
    } else if (!read_keywords().contains(keyword.name)) {
      others.insert(shortened(keyword.shown));
    } else if (keyword.step > 0 && keyword.step <= deck.last_step &&
               !step_keywords().contains(keyword.name)) {
      deck.leave_out(keyword.shown,
                     keyword.place,
                     "it stands in a step; put it above the first *STEP");
    }
  }
  std::string names;
  for (const std::string& name : others) {
    names += (names.empty() ? "" : ", ") + name;
  }
  if (!names.empty()) {
    deck.say("keywords that are not read, of loads, output or the like: " +
             names);
  }
  leave_out_preload(deck);
  warn_of_open_step(deck);
}

}  // namespace tapfit::structure
