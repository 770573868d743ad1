#include "updating/structure/edit/keyword_deck.hpp"

#include "acquisition/foundation/trimmed_text.hpp"
#include "updating/structure/abaqus/translate_inp.hpp"
#include "updating/structure/cards/bulk_numbers.hpp"
#include "updating/structure/cards/deck_source.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>
#include <set>

namespace tapfit::structure {
namespace {

/// Where a number stands: a line of the deck, a field of it.
struct NumberPlace {
  std::size_t line = 0;
  std::size_t field = 0;
};

using NumberPlaces = std::vector<NumberPlace>;

std::string elastic_type(const Keyword& keyword) {
  std::string type = keyword.option("TYPE");
  std::erase(type, ' ');
  return type;
}

// Field of each data line: one for each temperature.
NumberPlaces in_all_lines(const Keyword& keyword, std::size_t field) {
  NumberPlaces places;
  for (const DataLine& line : keyword.lines) {
    places.push_back({line.place.index, field});
  }
  return places;
}

NumberPlaces in_first_line(const Keyword& keyword, std::size_t field) {
  if (keyword.lines.empty()) return {};
  return {{keyword.lines.front().place.index, field}};
}

// The keyword of that name among a material's.
const Keyword* part_of_material(const KeywordDeck& deck,
                                std::size_t material,
                                const std::string& name) {
  for (std::size_t k = material; k < deck.material_end(material); ++k) {
    if (deck.keywords[k].name == name) return &deck.keywords[k];
  }
  return nullptr;
}

// Moduli that a factor makes stiffer: of engineering constants no ratios.
NumberPlaces all_moduli(const Keyword& elastic) {
  const std::string type = elastic_type(elastic);
  std::vector<std::size_t> at = {0, 1, 2, 6, 7, 8};
  if (type != "ENGINEERINGCONSTANTS") {
    at.resize(type.starts_with("ANISO") ? 21 : 9);
    for (std::size_t k = 0; k < at.size(); ++k) at[k] = k;
  }
  constexpr std::size_t per_line = 8;
  NumberPlaces places;
  for (const std::size_t k : at) {
    if (k / per_line >= elastic.lines.size()) return {};
    places.push_back({elastic.lines[k / per_line].place.index, k % per_line});
  }
  return places;
}

bool has_directions(const Keyword* elastic) {
  if (elastic == nullptr) return false;
  const std::string type = elastic_type(*elastic);
  return !type.empty() && !type.starts_with("ISO") && type != "LAMINA";
}

// Of a material's card; E and G of a section that has its own.
NumberPlaces material_places(const KeywordDeck& deck,
                             const Card& card,
                             std::size_t field) {
  const std::size_t at = deck.keyword_at(deck.line_of(card));
  if (deck.keywords[at].name != "MATERIAL") {
    if (field != 2 && field != 3) return {};
    return {{deck.line_of(card), field - 2}};
  }
  static const std::map<std::string, std::size_t> density = {
      {"MAT1", 5}, {"MAT8", 8}, {"MAT9", 23}};
  if (field == density.at(card.name())) {
    const Keyword* rho = part_of_material(deck, at, "DENSITY");
    return rho == nullptr ? NumberPlaces{} : in_all_lines(*rho, 0);
  }
  const Keyword* elastic = part_of_material(deck, at, "ELASTIC");
  if (elastic == nullptr || has_directions(elastic)) return {};
  if (card.name() != "MAT1") return in_all_lines(*elastic, field - 2);
  if (field == 3) return {};  // G follows from E and nu
  return in_all_lines(*elastic, field == 2 ? 0 : 1);
}

NumberPlaces places_of(const KeywordDeck& deck,
                       const Card& card,
                       std::size_t field) {
  const std::string& name = card.name();
  if (name.starts_with("MAT")) return material_places(deck, card, field);
  const Keyword& section = deck.keywords[deck.keyword_at(deck.line_of(card))];
  if ((name == "PSHELL" || name == "PROD") && field == 3) {
    return in_first_line(section, 0);
  }
  const bool general =
      section.name == "BEAMGENERALSECTION" &&
      (!section.has("SECTION") || section.option("SECTION") == "GENERAL");
  // A, I11, I12, I22, J: I1 of the card is I22.
  static const std::map<std::size_t, std::size_t> of_pbeam = {
      {3, 0}, {4, 3}, {5, 1}, {6, 2}, {7, 4}};
  if (name == "PBEAM" && general && of_pbeam.contains(field)) {
    return in_first_line(section, of_pbeam.at(field));
  }
  return {};
}

void scale(const NumberPlaces& places, double factor, KeywordText& text) {
  for (const NumberPlace& at : places) {
    const auto line = text.find(at.line);
    if (line == text.end() || line->second.field(at.field).empty()) continue;
    const DataLine number{{line->second.field(at.field)}, {}, false};
    const double value = factor * number_in(number, 0, "number");
    // A point for CalculiX.
    line->second.set(at.field, fmt::format("{:#.10g}", value));
  }
}

// How many moduli a MAT8 or MAT9 has: its numbers but ratio and density.
std::size_t modulus_count(const Card& card) {
  const std::size_t end = card.name() == "MAT8" ? 8 : 23;
  std::size_t count = 0;
  for (std::size_t k = 2; k < std::min(end, card.fields.size()); ++k) {
    const bool ratio = card.name() == "MAT8" && k == 4;
    const bool given = parse_real(card.fields[k]).value_or(0.0) != 0.0;
    count += given && !ratio ? 1 : 0;
  }
  return count;
}

// All moduli of a material with directions, where they change alike.
bool scale_moduli(const KeywordDeck& deck,
                  const Card& card,
                  const std::vector<double>& factors,
                  KeywordText& text) {
  if (!card.name().starts_with("MAT")) return false;
  const std::size_t at = deck.keyword_at(deck.line_of(card));
  const Keyword* elastic = part_of_material(deck, at, "ELASTIC");
  constexpr double rounding = 1e-6;
  const bool alike = std::ranges::all_of(factors, [&](double f) {
    return std::abs(f - factors.front()) < rounding * factors.front();
  });
  if (!alike || !has_directions(elastic) ||
      factors.size() != modulus_count(card)) {
    return false;
  }
  const NumberPlaces places = all_moduli(*elastic);
  scale(places, factors.front(), text);
  return !places.empty();
}

}  // namespace

std::size_t KeywordDeck::line_of(const Card& card) const {
  return origins.at(card.lines.front());
}

std::size_t KeywordDeck::keyword_at(std::size_t line) const {
  const auto next = std::ranges::upper_bound(
      keywords, line, {}, [](const Keyword& k) { return k.place.index; });
  return static_cast<std::size_t>(next - keywords.begin()) - 1;
}

std::size_t KeywordDeck::material_end(std::size_t keyword) const {
  static const std::set<std::string> others = {"ELASTIC",
                                               "DENSITY",
                                               "EXPANSION",
                                               "PLASTIC",
                                               "CYCLICHARDENING",
                                               "CREEP",
                                               "DAMPING",
                                               "CONDUCTIVITY",
                                               "SPECIFICHEAT",
                                               "DEPVAR"};
  std::size_t end = keyword + 1;
  while (end < keywords.size() && others.contains(keywords[end].name)) ++end;
  return end;
}

KeywordText KeywordDeck::text_of(std::size_t keyword) const {
  KeywordText text;
  const std::size_t end = keyword + 1 < keywords.size()
                              ? keywords[keyword + 1].place.index
                              : lines.size();
  for (std::size_t k = keywords[keyword].place.index; k < end; ++k) {
    const std::string line = trimmed(lines[k]);
    if (line.empty() || line.starts_with("**")) continue;
    text.emplace(k, FieldLine::of_keyword(lines[k]));
  }
  return text;
}

KeywordDeck read_keyword_deck(const std::filesystem::path& path) {
  const DeckSource source = read_deck_source(path);
  KeywordDeck deck;
  deck.keywords = keyword_blocks(source.lines);
  for (const PlacedLine& line : source.lines) deck.lines.push_back(line.text);
  for (const PlacedLine& line : translate_inp(source.lines).lines) {
    deck.origins.push_back(line.origin);
  }
  return deck;
}

void set_option(const std::string& name,
                const std::string& value,
                KeywordText& text) {
  for (auto& [at, line] : text) {
    for (std::size_t k = 0; k < line.size(); ++k) {
      const std::string cell = line.field(k);
      const std::size_t equals = cell.find('=');
      if (equals == std::string::npos) continue;
      std::string own = upper(cell.substr(0, equals));
      std::erase_if(own, [](unsigned char c) { return std::isspace(c) != 0; });
      if (own == name) line.set(k, cell.substr(0, equals + 1) + value);
    }
  }
}

bool scale_numbers(const KeywordDeck& deck,
                   const Card& before,
                   const Card& after,
                   KeywordText& text) {
  std::vector<double> others;
  for (std::size_t k = 2; k < after.fields.size(); ++k) {
    const std::string old = k < before.fields.size() ? before.fields[k] : "";
    if (after.fields[k] == old || parse_integer(after.fields[k])) continue;
    const std::optional<double> from = parse_real(old);
    const std::optional<double> to = parse_real(after.fields[k]);
    if (!from || !to) return false;
    if (*from == 0.0) continue;
    const NumberPlaces places = places_of(deck, before, k);
    if (places.empty()) others.push_back(*to / *from);
    scale(places, *to / *from, text);
  }
  return others.empty() || scale_moduli(deck, before, others, text);
}

}  // namespace tapfit::structure
