#include "updating/structure/readers/unsupported_cards.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "updating/structure/cards/bulk_lines.hpp"
#include "updating/structure/cards/card_defaults.hpp"
#include "updating/structure/cards/listed.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <map>
#include <set>

namespace tapfit::structure {
namespace {

// Cards that say what to solve for and change nothing of the model.
bool is_silent(const std::string& name) {
  static const std::set<std::string> silent{
      "EIGRL", "EIGR", "EIGB", "EIGC", "FREQ", "FREQ1", "FREQ2", "TSTEP"};
  return silent.contains(name);
}

bool starts_with_any(const std::string& name,
                     std::initializer_list<const char*> beginnings) {
  return std::any_of(
      beginnings.begin(), beginnings.end(), [&](const char* beginning) {
        return name.starts_with(beginning);
      });
}

// Loads, temperatures, aerodynamics, optimisation, tables, plots, damping,
// heat, control, sets of a reduction: nothing that the modes see.
bool is_harmless(const std::string& name) {
  static const std::set<std::string> whole_names{
      "CLOAD", "CREEP", "COUNT", "CASECC"};
  if (whole_names.contains(name)) return true;
  return starts_with_any(
      name, {"FREQ",    "TSTEP",   "DLOAD",   "RLOAD",   "TLOAD",   "DAREA",
             "DELAY",   "DPHASE",  "FORCE",   "MOMENT",  "GRAV",    "RFORCE",
             "LOAD",    "LSEQ",    "PLOAD",   "SLOAD",   "ACCEL",   "TEMP",
             "QBDY",    "QHBDY",   "QVECT",   "QVOL",    "CHBDY",   "PHBDY",
             "CONV",    "PCONV",   "RAD",     "VIEW",    "MATT",    "MATS",
             "MATF",    "TABL",    "TABD",    "TABR",    "TIC",     "SPCD",
             "SPCR",    "SET1",    "SET2",    "SET3",    "SETREE",  "MONPNT",
             "MONDSP",  "MONSUM",  "AE",      "AERO",    "CAERO",   "PAERO",
             "SPLINE",  "MKAERO",  "FLFACT",  "FLUTTER", "FLSYM",   "TRIM",
             "DIVERG",  "GUST",    "CSSCHD",  "DMI",     "DMIJ",    "DMIK",
             "DESVAR",  "DVPREL",  "DVCREL",  "DVMREL",  "DVGRID",  "DVBSHAP",
             "DVSHAP",  "DRESP",   "DCON",    "DSCREEN", "DOPTPRM", "DLINK",
             "DDVAL",   "DEQATN",  "DESSUB",  "DTABLE",  "DTI",     "USET",
             "ASET",    "OMIT",    "BSET",    "CSET",    "QSET",    "BNDF",
             "BNDG",    "BNDR",    "SUPORT",  "CVISC",   "PVISC",   "CDAMP5",
             "PDAMP5",  "PDAMPT",  "PBUSHT",  "PELAST",  "CBARAO",  "PLOTEL",
             "NOLIN",   "NLPARM",  "NLPCI",   "TF",      "EPOINT",  "RANDPS",
             "RANDT",   "RGYRO",   "ROTOR",   "RSPIN",   "UNBAL",   "GEOMCHECK",
             "MDLPRM",  "MODTRAK", "NSMADD",  "POINT",   "FEEDGE",  "FEFACE",
             "GMCURV",  "GMSURF",  "PRESPT",  "CSCHD",   "ECHO",    "SEUSET",
             "SEQSET",  "SEBSET",  "SECSET",  "SESET",   "SWLDPRM", "TSTEPNL",
             "VCEV",    "HYBDAMP", "DAMPING", "CYSUP",   "CYSYM",   "PARAMARM",
             "MESHREP", "BCPARA",  "ACMODL",  "CAMPBLL", "FATIGUE", "FTGDEF"});
}

// Nonstructural mass counts where the case control chooses it.
bool is_unchosen(const std::string& name, const CaseControl& control) {
  return name.starts_with("NSM") && control.selects &&
         !control.commands.contains("NSM");
}

std::string consequence(const std::string& name) {
  if (name.starts_with("RB") || name.starts_with("RROD") ||
      name.starts_with("RTRPLT") || name.starts_with("RS") ||
      name.starts_with("RJOINT") || name.starts_with("MPC")) {
    return "a rigid connection is left out: the model is softer or falls "
           "apart";
  }
  if (name == "MFLUID") {
    return "the mass of the fluid is missing from the model; give it by masses "
           "(CONM2, NSM) on the wetted parts";
  }
  if (name == "GMBC" || name == "GMSPC") {
    return "a support is missing from the model; write it as SPC1";
  }
  if (name.starts_with("NSM")) {
    return "nonstructural mass is missing from the model; give it by the NSM "
           "of its properties";
  }
  if (name.starts_with("SPC")) return "a support is missing from the model";
  if (name.starts_with("BG") || name.starts_with("BC") ||
      name.starts_with("BS")) {
    return "what is glued or in contact is missing from the model; join it by "
           "equal grids or RBE2";
  }
  if (name.starts_with("SE") || name == "RELEASE") {
    return "superelements are missing from the model; write it as one";
  }
  if (name.starts_with("CORD")) return "cards that refer to it fail";
  if (name.starts_with("C")) {
    return "these elements' stiffness and mass are missing from the model";
  }
  if (name == "GENEL") return "its stiffness is missing from the model";
  if (name.starts_with("M")) return "the material is not known";
  if (name.starts_with("P")) return "the property is not known";
  return "it is left out of the model";
}

// Other cards refer to it, or leave fields blank that it fills.
bool defines(const std::string& name) {
  return name.starts_with("CORD") || name.starts_with("P") ||
         (name.starts_with("M") && !name.starts_with("MPC") &&
          name != "MFLUID");
}

// The model lacks stiffness, mass or a constraint without it.
bool is_needed(const std::string& name) {
  if (defines(name)) return false;
  return starts_with_any(
      name, {"C",      "MFLUID",  "GMBC",   "GMSPC",  "RB",      "RROD",
             "RTRPLT", "RSPLINE", "RSSCON", "RJOINT", "MPC",     "NSM",
             "SPC",    "BGSET",   "BGADD",  "BCTSET", "BCTABLE", "BCBODY",
             "SEBULK", "SECONCT", "SEELT",  "SELOC",  "GENEL"});
}

// Keywords of Abaqus hold blanks, which do not count.
std::string without_blanks(std::string name) {
  std::erase(name, ' ');
  return name;
}

struct Unknown {
  std::string where;  // of the first
  int line = 0;
  int count = 0;
};

bool is_read(const std::string& name, const std::vector<CardTable>& passes) {
  return std::ranges::any_of(
      passes, [&](const CardTable& table) { return table.contains(name); });
}

}  // namespace

void take_out(const std::vector<std::string>& ignored,
              const std::vector<CardTable>& passes,
              BulkData& bulk) {
  for (const std::string& text : ignored) {
    const std::string name = without_blanks(upper(text));
    const auto is_it = [&name](const Card& card) {
      return card.name() == name;
    };
    const bool is_keyword =
        std::ranges::any_of(bulk.left_out, [&name](const LeftOut& own) {
          return without_blanks(upper(own.name)) == name;
        });
    const auto count = std::ranges::count_if(bulk.cards, is_it);
    if (count == 0 && !is_keyword) {
      bulk.warnings.push_back(fmt::format(
          "{} is to be left out, but the deck has no such card", text));
    } else if (is_read(name, passes)) {
      std::erase_if(bulk.cards, is_it);
      bulk.warnings.push_back(
          fmt::format("{} ({} in all) left out, as asked: the model lacks what "
                      "it says",
                      name,
                      count));
    }
  }
}

UnsupportedCards unsupported_cards(const BulkData& bulk,
                                   const std::vector<CardTable>& passes) {
  std::map<std::string, Unknown> unknown;
  for (const Card& card : bulk.cards) {
    if (is_read(card.name(), passes) || is_silent(card.name()) ||
        is_default_card(card.name())) {
      continue;
    }
    Unknown& seen = unknown[card.name()];
    if (seen.count++ == 0) {
      seen.line = card.line;
      seen.where = card.where;
    }
  }
  UnsupportedCards result;
  for (const LeftOut& own : bulk.left_out) {
    result.needed.push_back({own.name, own.where, own.text, false});
  }
  std::vector<std::string> harmless;
  for (const auto& [name, seen] : unknown) {
    if (is_harmless(name) || is_unchosen(name, bulk.control)) {
      harmless.push_back(name);
      continue;
    }
    const UnsupportedCard card{
        name,
        seen.where,
        fmt::format("{} (line {}, {} in all) is not supported: {}",
                    name,
                    seen.line,
                    seen.count,
                    consequence(name)),
        defines(name)};
    (is_needed(name) ? result.needed : result.others).push_back(card);
  }
  if (!harmless.empty()) {
    constexpr std::size_t shown = 40;
    result.ignored = fmt::format(
        "ignored, for they change nothing of the "
        "modes: {}",
        listed(harmless, shown));
  }
  return result;
}

void refuse_needed(const UnsupportedCards& cards,
                   const std::vector<std::string>& ignored) {
  std::vector<const UnsupportedCard*> left;
  for (const UnsupportedCard& card : cards.needed) {
    const bool given_up = std::any_of(
        ignored.begin(), ignored.end(), [&](const std::string& name) {
          return without_blanks(upper(name)) == without_blanks(card.name);
        });
    if (!given_up) left.push_back(&card);
  }
  if (left.empty()) return;
  std::string text = left.front()->text;
  for (std::size_t k = 1; k < left.size(); ++k) text += "; " + left[k]->text;
  throw InputError(
      text,
      left.front()->where,
      fmt::format("Write it with cards that are read, or leave it out "
                  "knowingly: \"ignore_cards\": [\"{0}\"] in test.json, "
                  "--ignore-card {0} of tapfit model.",
                  without_blanks(left.front()->name)));
}

}  // namespace tapfit::structure
