// Which keywords are read, which change nothing of the modes, and which the
// model lacks something without.
#include "updating/structure/abaqus/inp_deck.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace tapfit::structure {
namespace {

using Names = std::set<std::string>;

bool is_read(const std::string& name) {
  static const Names names{"HEADING",
                           "NODE",
                           "ELEMENT",
                           "NSET",
                           "ELSET",
                           "INCLUDE",
                           "MATERIAL",
                           "ELASTIC",
                           "DENSITY",
                           "SOLIDSECTION",
                           "SHELLSECTION",
                           "SHELLGENERALSECTION",
                           "MEMBRANESECTION",
                           "NODALTHICKNESS",
                           "BEAMSECTION",
                           "BEAMGENERALSECTION",
                           "MASS",
                           "ROTARYINERTIA",
                           "SPRING",
                           "DASHPOT",
                           "BOUNDARY",
                           "EQUATION",
                           "RIGIDBODY",
                           "KINEMATICCOUPLING",
                           "COUPLING",
                           "KINEMATIC",
                           "DISTRIBUTING",
                           "MPC",
                           "TIE",
                           "SURFACE",
                           "TRANSFORM",
                           "ORIENTATION",
                           "PART",
                           "ENDPART",
                           "INSTANCE",
                           "ENDINSTANCE",
                           "ASSEMBLY",
                           "ENDASSEMBLY",
                           "STEP",
                           "ENDSTEP",
                           "FREQUENCY",
                           "COMPLEXFREQUENCY",
                           "PREPRINT",
                           "STATIC"};
  return names.contains(name);
}

// What the model lacks without it; "" where it lacks nothing.
std::string lack(const std::string& name) {
  static const std::map<std::string, std::string> lacks{
      {"CONTACTPAIR", "what is in contact comes apart; join it by *TIE"},
      {"CONTACT", "what is in contact comes apart; join it by *TIE"},
      {"CONTACTINCLUSIONS", "what is in contact comes apart"},
      {"CYCLICSYMMETRYMODEL",
       "a sector is not closed to the whole; write the whole model"},
      {"USERELEMENT", "these elements' stiffness and mass are missing"},
      {"USERMATERIAL", "the material is not known; write *ELASTIC"},
      {"HYPERELASTIC", "the material is not known; write *ELASTIC"},
      {"HYPERFOAM", "the material is not known; write *ELASTIC"},
      {"MATRIXINPUT", "a matrix is missing from the model"},
      {"MATRIXASSEMBLE", "a matrix is missing from the model"},
      {"SUPERELEMENT", "substructures are missing; write the whole model"},
      {"SUBSTRUCTUREPROPERTY", "substructures are missing"},
      {"SUBSTRUCTUREGENERATE", "substructures are missing"},
      {"SUBMODEL", "its edges are driven by another model"},
      {"GAP", "what closes a gap comes apart"},
      {"SHELLTOSOLIDCOUPLING", "shells and solids come apart; use *TIE"},
      {"EMBEDDEDELEMENT", "what is embedded comes apart"},
      {"DISTRIBUTINGCOUPLING",
       "a coupling is missing; use *COUPLING with *DISTRIBUTING"},
      {"PRE-TENSIONSECTION", "what it joins comes apart"},
      {"CONNECTORSECTION", "connectors are missing; use springs or *MPC"},
      {"FASTENER", "fasteners are missing"},
      {"COHESIVESECTION", "what it glues comes apart; use *TIE"},
      {"GASKETSECTION", "gaskets are missing"},
      {"JOINT", "joints are missing; use springs"},
      {"ITS", "supports of tubes are missing"},
      {"FOUNDATION", "an elastic foundation is missing; use springs"},
      {"NONSTRUCTURALMASS",
       "mass is missing; put it into the density or into *MASS"},
      {"BEAMADDEDINERTIA", "mass is missing; use *MASS"},
      {"RELEASE", "hinges at the ends of beams are missing"},
      {"REBAR", "reinforcement is missing"},
      {"REBARLAYER", "reinforcement is missing"},
      {"FRAMESECTION", "frame elements are missing; use B31"},
      {"LINK", "links are missing"},
      {"PERIODIC", "a periodic constraint is missing"},
      {"MODELCHANGE", "parts are taken out of or put into the model"},
      {"TRANSVERSESHEARSTIFFNESS",
       "a section's shear stiffness is another one; leave it to the program"},
      {"INERTIARELIEF", "the structure's support is another one"},
      {"NGEN", "nodes are missing; write them out"},
      {"NFILL", "nodes are missing; write them out"},
      {"NCOPY", "nodes are missing; write them out"},
      {"NMAP", "nodes are elsewhere; write their places out"},
      {"SYSTEM", "nodes are elsewhere; write their places out"},
      {"ELGEN", "elements are missing; write them out"},
      {"ELCOPY", "elements are missing; write them out"},
      {"IMPORT", "the model is in another file; write it out"},
      {"ELEMENTPROPERTIES", "properties of elements are missing"},
      {"CHANGEMATERIAL", "the material changes on the way"},
      {"CHANGESOLIDSECTION", "the section changes on the way"},
      {"IMPERFECTION", "nodes are elsewhere; write their places out"}};
  const auto found = lacks.find(name);
  return found == lacks.end() ? "" : found->second;
}

bool is_output(const std::string& name) {
  static const Names names{
      "NODEPRINT",   "NODEFILE",      "NODEOUTPUT",   "ELPRINT",
      "ELFILE",      "ELEMENTOUTPUT", "OUTPUT",       "HISTORYOUTPUT",
      "FIELDOUTPUT", "CONTACTOUTPUT", "CONTACTPRINT", "CONTACTFILE",
      "ENERGYPRINT", "ENERGYOUTPUT",  "ENERGYFILE",   "MODALPRINT",
      "MODALOUTPUT", "MODALFILE",     "SECTIONPRINT", "SECTIONFILE",
      "FACEPRINT",   "FILEFORMAT",    "FILEOUTPUT",   "PRINT",
      "MONITOR",     "RESTART",       "TIMEPOINTS",   "FILTER"};
  return names.contains(name);
}

bool is_load_or_analysis(const std::string& name) {
  static const Names names{"CLOAD",
                           "DLOAD",
                           "DSLOAD",
                           "TEMPERATURE",
                           "INITIALCONDITIONS",
                           "AMPLITUDE",
                           "DYNAMIC",
                           "MODALDYNAMIC",
                           "STEADYSTATEDYNAMICS",
                           "MODALDAMPING",
                           "DAMPING",
                           "GLOBALDAMPING",
                           "BUCKLE",
                           "VISCO",
                           "HEATTRANSFER",
                           "SENSITIVITY",
                           "OBJECTIVE",
                           "DESIGNVARIABLES",
                           "DESIGNRESPONSE",
                           "CONSTRAINT",
                           "SELECTCYCLICSYMMETRYMODES",
                           "BASEMOTION",
                           "RESPONSESPECTRUM",
                           "SPECTRUM",
                           "RANDOMRESPONSE",
                           "PSD-DEFINITION",
                           "CORRELATION",
                           "SELECTEIGENMODES",
                           "CONTROLS",
                           "CONSTRAINTCONTROLS",
                           "SOLVERCONTROLS",
                           "SOLUTIONTECHNIQUE",
                           "NOANALYSIS",
                           "CONTACTCONTROLS",
                           "PERTURBATION",
                           "INCREMENTATION",
                           "CFLUX",
                           "DFLUX",
                           "FILM",
                           "SFILM",
                           "RADIATE",
                           "SRADIATE",
                           "INERTIALOAD",
                           "PARAMETER",
                           "GEOSTATIC",
                           "CRADIATE"};
  return names.contains(name);
}

bool is_of_contact(const std::string& name) {
  static const Names names{"SURFACEINTERACTION",
                           "SURFACEBEHAVIOR",
                           "FRICTION",
                           "CONTACTDAMPING",
                           "CONTACTINITIALIZATION",
                           "CLEARANCE",
                           "GAPCONDUCTANCE",
                           "CHANGEFRICTION",
                           "CHANGESURFACEBEHAVIOR",
                           "CHANGECONTACTTYPE",
                           "CONTACTPROPERTYASSIGNMENT",
                           "CONTACTINITIALIZATIONASSIGNMENT",
                           "CONTACTFORMULATION",
                           "CONTACTEXCLUSIONS",
                           "SURFACEPROPERTYASSIGNMENT"};
  return names.contains(name);
}

bool is_of_material(const std::string& name) {
  static const Names names{"EXPANSION",
                           "CONDUCTIVITY",
                           "SPECIFICHEAT",
                           "LATENTHEAT",
                           "PLASTIC",
                           "CYCLICHARDENING",
                           "CREEP",
                           "RATEDEPENDENT",
                           "VISCOELASTIC",
                           "DEPVAR",
                           "DEFORMATIONPLASTICITY",
                           "DAMAGEINITIATION",
                           "DAMAGEEVOLUTION",
                           "FAILSTRESS",
                           "FAILSTRAIN",
                           "ELECTRICALCONDUCTIVITY",
                           "POTENTIAL",
                           "MAGNETICPERMEABILITY",
                           "FLUIDCONSTANTS",
                           "SPECIFICGASCONSTANT",
                           "PHYSICALCONSTANTS",
                           "CHANGEPLASTIC",
                           "SECTIONCONTROLS",
                           "HOURGLASSSTIFFNESS",
                           "SECTIONPOINTS",
                           "DISPLAYBODY",
                           "DISTRIBUTIONTABLE",
                           "BRITTLECRACKING",
                           "CENTROID",
                           "VIEWFACTOR",
                           "VALUESATINFINITY",
                           "USEROUTPUTVARIABLES"};
  return names.contains(name);
}

// Changes nothing of the modes.
bool is_harmless_keyword(const std::string& name) {
  return is_output(name) || is_load_or_analysis(name) || is_of_contact(name) ||
         is_of_material(name);
}

bool solves_for_modes(const Keyword& keyword) {
  return keyword.name == "FREQUENCY" || keyword.name == "COMPLEXFREQUENCY";
}

int step_of_modes(const std::vector<Keyword>& keywords) {
  const auto found = std::ranges::find_if(keywords, solves_for_modes);
  return found == keywords.end() ? 1 : std::max(1, found->step);
}

std::string joined(const Names& names) {
  std::string text;
  for (const std::string& name : names) {
    text += (text.empty() ? "" : ", ") + name;
  }
  return text;
}

// A frequency step on top of a loaded state.
void warn_prestress(InpDeck& deck) {
  bool loaded = false;
  for (const Keyword& keyword : deck.keywords) {
    if (keyword.step == 0 || keyword.step > deck.last_step) continue;
    const bool before = keyword.step < deck.last_step;
    loaded = loaded || (before && keyword.name == "STATIC");
    if (keyword.name == "STEP" && !before && loaded &&
        keyword.has("PERTURBATION")) {
      say(deck,
          keyword.place.where +
              ": the state that the steps before it load is not taken: modes "
              "are those of the structure without stress");
    }
  }
}

}  // namespace

void sort_keywords(InpDeck& deck) {
  deck.last_step = step_of_modes(deck.keywords);
  LeftOutCounts counts;
  Names ignored;
  std::map<std::string, Place> unknown;
  for (const Keyword& keyword : deck.keywords) {
    // Those that name a file have been inlined.
    if (keyword.name == "INCLUDE") {
      keyword.fail("it names no file", "Write *INCLUDE, INPUT=file.");
    }
    const std::string why = lack(keyword.name);
    if (!why.empty()) {
      count_left_out(counts, keyword.shown, keyword.place, why);
    } else if (is_harmless_keyword(keyword.name)) {
      ignored.insert(keyword.shown);
    } else if (!is_read(keyword.name)) {
      unknown.try_emplace(keyword.shown, keyword.place);
    }
  }
  add_left_out(deck, counts);
  for (const auto& [name, place] : unknown) {
    constexpr std::size_t most = 40;
    say(deck,
        fmt::format("{}: the keyword *{} is not known and left out",
                    place.where,
                    name.substr(0, most)));
  }
  if (!ignored.empty()) {
    say(deck,
        "ignored, for they change nothing of the modes: " + joined(ignored));
  }
  warn_prestress(deck);
}

}  // namespace tapfit::structure
