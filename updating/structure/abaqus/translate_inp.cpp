#include "updating/structure/abaqus/translate_inp.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "updating/structure/abaqus/inp_deck.hpp"

#include <algorithm>

namespace tapfit::structure {
namespace {

// Names of sets and materials as ids of bulk data, the first ones.
std::string ids_of_names(const std::vector<std::string>& named) {
  constexpr std::size_t most = 20;
  std::string text;
  for (std::size_t k = 0; k < std::min(most, named.size()); ++k) {
    text += (k == 0 ? "; " : ", ") + named[k];
  }
  if (named.size() > most) {
    text += fmt::format(" and {} more", named.size() - most);
  }
  return text;
}

std::vector<PlacedLine> with_control(const std::vector<PlacedLine>& cards) {
  const auto has_card = [&](const char* name) {
    return std::ranges::any_of(cards, [&](const PlacedLine& line) {
      return line.text.starts_with(name);
    });
  };
  std::vector<PlacedLine> lines{
      {"$ An Abaqus or CalculiX deck, translated to bulk data", "", 0},
      {"SOL 103", "", 0},
      {"CEND", "", 0}};
  if (has_card("SPC1")) lines.push_back({"SPC = 1", "", 0});
  if (has_card("MPC")) lines.push_back({"MPC = 1", "", 0});
  lines.push_back({"BEGIN BULK", "", 0});
  lines.push_back({"PARAM   COUPMASS1", "", 0});
  lines.insert(lines.end(), cards.begin(), cards.end());
  lines.push_back({"ENDDATA", "", 0});
  return lines;
}

void translate(InpDeck& deck) {
  read_inp_nodes(deck);
  read_inp_elements(deck);
  read_inp_sets(deck);
  read_inp_surfaces(deck);
  read_inp_orientations(deck);
  read_inp_materials(deck);
  find_turning_nodes(deck);
  write_inp_grids(deck);
  write_solid_sections(deck);
  write_shell_sections(deck);
  write_beam_sections(deck);
  write_point_elements(deck);
  write_inp_elements(deck);
  write_inp_rigids(deck);
  write_inp_equations(deck);
  write_inp_ties(deck);
  write_inp_boundary(deck);
}

std::vector<LeftOut> left_out_of(const InpDeck& deck) {
  std::vector<LeftOut> all;
  for (const auto& [name, seen] : deck.left_out) {
    all.push_back({name,
                   seen.place.where,
                   fmt::format("{} (line {}, {} in all) is not read: {}",
                               name,
                               seen.place.number,
                               seen.count,
                               seen.consequence)});
  }
  return all;
}

// What is not read may be why something is missing.
InputError with_left_out(const InputError& error,
                         const std::vector<LeftOut>& left_out) {
  constexpr std::size_t most = 3;
  std::string remedy = error.remedy();
  for (std::size_t k = 0; k < std::min(most, left_out.size()); ++k) {
    remedy += (k == 0 ? " It may come from: " : "; ") + left_out[k].text;
  }
  return {error.fault(), error.where(), remedy};
}

}  // namespace

TranslatedDeck translate_inp(const std::vector<PlacedLine>& lines) {
  InpDeck deck;
  deck.keywords = keyword_blocks(lines);
  flatten_assembly(deck);
  sort_keywords(deck);
  try {
    translate(deck);
  } catch (const InputError& error) {
    throw with_left_out(error, left_out_of(deck));
  }
  TranslatedDeck result;
  result.lines = with_control(deck.cards.lines());
  result.left_out = left_out_of(deck);
  result.warnings.push_back("an Abaqus or CalculiX deck, read as bulk data" +
                            ids_of_names(deck.named));
  result.warnings.insert(
      result.warnings.end(), deck.warnings.begin(), deck.warnings.end());
  return result;
}

}  // namespace tapfit::structure
