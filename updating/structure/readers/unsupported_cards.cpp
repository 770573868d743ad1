#include "updating/structure/readers/unsupported_cards.hpp"

#include "updating/structure/cards/card_defaults.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace tapfit::structure {
namespace {

// Cards that say how to solve or print and change nothing of the model.
bool is_silent(const std::string& name) {
  static const std::set<std::string> kSilent{
      "EIGRL", "EIGR",   "EIGB",   "EIGC",   "FREQ",   "FREQ1", "FREQ2",
      "TSTEP", "DLOAD",  "RLOAD1", "RLOAD2", "TLOAD1", "DAREA", "TABLED1",
      "FORCE", "MOMENT", "GRAV",   "LOAD",   "PLOAD4", "SET1",  "MONPNT1"};
  return kSilent.contains(name);
}

bool is_scalar_point(const std::string& name) {
  return name == "SPOINT" || name == "EPOINT";
}

std::string consequence(const std::string& name) {
  if (name == "DMIG") return "matrices given directly are left out";
  if (is_scalar_point(name)) {
    return "cards that refer to these points fail; use a GRID of which five "
           "components are held";
  }
  if (name.starts_with("=")) {
    return "what it repeats is missing from the model; write the cards out";
  }
  if (name == "RBE3") {
    return "its reference grid is left loose: what hangs on it, masses too, is "
           "missing from the model";
  }
  if (name.starts_with("RB") || name.starts_with("RROD") || name == "MPC") {
    return "a rigid connection is left out: the model is softer or falls "
           "apart";
  }
  if (name.starts_with("SUPORT") || name.starts_with("ASET")) {
    return "it only steers the reduction, the model is unchanged";
  }
  if (name.starts_with("AE") || name.starts_with("CAERO") ||
      name.starts_with("PAERO") || name.starts_with("SPLINE") ||
      name.starts_with("MKAERO") || name.starts_with("FL")) {
    return "aerodynamics are left out";
  }
  if (name.starts_with("CORD")) return "cards that refer to it fail";
  if (name.starts_with("DES") || name.starts_with("DV") ||
      name.starts_with("DRESP") || name.starts_with("DCON")) {
    return "design optimisation is left out, the model is as given";
  }
  if (name.starts_with("C")) {
    return "these elements' stiffness and mass are missing from the model";
  }
  if (name.starts_with("M")) return "the material is not known";
  if (name.starts_with("P")) return "the property is not known";
  return "it is left out of the model";
}

// Other cards refer to it, or leave fields blank that it fills.
bool defines(const std::string& name) {
  return is_scalar_point(name) || name.starts_with("CORD") ||
         name.starts_with("P") ||
         (name.starts_with("M") && !name.starts_with("MKAERO") &&
          name != "MPC");
}

struct Unknown {
  int line = 0;  // of the first
  int count = 0;
};

}  // namespace

std::vector<UnsupportedCard> unsupported_cards(
    const BulkData& bulk, const std::vector<CardTable>& passes) {
  std::map<std::string, Unknown> unknown;
  for (const Card& card : bulk.cards) {
    const bool known =
        std::any_of(passes.begin(), passes.end(), [&](const CardTable& table) {
          return table.contains(card.name());
        });
    if (known || is_silent(card.name()) || is_default_card(card.name())) {
      continue;
    }
    Unknown& seen = unknown[card.name()];
    if (seen.count++ == 0) seen.line = card.line;
  }
  std::vector<UnsupportedCard> cards;
  for (const auto& [name, seen] : unknown) {
    cards.push_back({fmt::format("{} (line {}, {} in all) is not supported: {}",
                                 name,
                                 seen.line,
                                 seen.count,
                                 consequence(name)),
                     defines(name)});
  }
  return cards;
}

}  // namespace tapfit::structure
