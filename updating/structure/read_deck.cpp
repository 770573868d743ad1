#include "acquisition/input_error.hpp"
#include "updating/structure/bulk_cards.hpp"
#include "updating/structure/deck.hpp"
#include "updating/structure/deck_builder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
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

std::string consequence(const std::string& name) {
  if (name == "DMIG") return "matrices given directly are left out";
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

struct Unknown {
  int line = 0;  // of the first
  int count = 0;
};

void warn_unknown(const BulkData& bulk,
                  const std::vector<CardTable>& passes,
                  Deck& deck) {
  std::map<std::string, Unknown> unknown;
  for (const Card& card : bulk.cards) {
    const bool known =
        std::any_of(passes.begin(), passes.end(), [&](const CardTable& table) {
          return table.contains(card.name());
        });
    if (known || is_silent(card.name())) continue;
    Unknown& seen = unknown[card.name()];
    if (seen.count++ == 0) seen.line = card.line;
  }
  for (const auto& [name, seen] : unknown) {
    deck.warnings.push_back(
        fmt::format("{} (line {}, {} in all) is not supported: {}",
                    name,
                    seen.line,
                    seen.count,
                    consequence(name)));
  }
}

std::set<int> attached_grids(const Deck& deck) {
  std::set<int> grids;
  const auto take = [&grids](const auto& elements) {
    for (const auto& e : elements) {
      grids.insert(e.grids.begin(), e.grids.end());
    }
  };
  take(deck.shells);
  take(deck.bars);
  take(deck.rods);
  take(deck.scalars);
  take(deck.bushes);
  for (const PointMass& e : deck.masses) grids.insert(e.grid);
  for (const RigidElement& e : deck.rigids) {
    grids.insert(e.independent);
    for (const Dependent& d : e.dependents) grids.insert(d.grid);
  }
  for (const std::array<int, 2>& ends : deck.plot_lines) {
    grids.insert(ends.begin(), ends.end());
  }
  return grids;
}

// The grid that orients a bar need not be part of the model.
std::optional<int> orienting_grid(const Card& card) {
  const std::string& name = card.name();
  if (name != "CBAR" && name != "CBEAM" && name != "CBUSH") return {};
  return parse_integer(CardReader(card).text(5));
}

void warn_unattached(const BulkData& bulk, Deck& deck) {
  std::set<int> attached = attached_grids(deck);
  for (const Card& card : bulk.cards) {
    const std::optional<int> grid = orienting_grid(card);
    if (grid) attached.insert(*grid);
  }
  int first = 0;
  Unknown loose;
  for (const Card& card : bulk.cards) {
    if (card.name() != "GRID") continue;
    const int id = CardReader(card).id(1, "ID");
    if (attached.contains(id)) continue;
    if (loose.count++ == 0) {
      first = id;
      loose.line = card.line;
    }
  }
  if (loose.count == 0) return;
  deck.warnings.push_back(fmt::format(
      "GRID {} (line {}, {} in all) is attached to no element: it is left out "
      "of the modes; attach or remove it",
      first,
      loose.line,
      loose.count));
}

}  // namespace

Deck read_deck(const std::filesystem::path& path) {
  const BulkData bulk = read_bulk_data(path);
  const std::vector<CardTable> passes{coordinate_cards(),
                                      grid_cards(),
                                      grid_coordinate_cards(),
                                      grid_axes_cards(),
                                      property_cards(),
                                      element_cards(),
                                      rigid_cards(),
                                      constraint_cards()};
  DeckBuilder builder;
  builder.deck.path = path;
  builder.deck.cards = bulk.lines;
  for (const CardTable& table : passes) {
    for (const Card& card : bulk.cards) {
      const auto reader = table.find(card.name());
      if (reader != table.end()) reader->second(builder, CardReader(card));
    }
  }
  apply_constraints(builder, bulk.spc_set);
  warn_unknown(bulk, passes, builder.deck);
  if (builder.deck.grids.empty()) {
    throw InputError("the model has no GRID",
                     path.string(),
                     "Check that this is Nastran bulk data.");
  }
  check_references(builder.deck);
  warn_unattached(bulk, builder.deck);
  return builder.deck;
}

}  // namespace tapfit::structure
