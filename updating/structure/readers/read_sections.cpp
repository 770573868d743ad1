// PBAR, PBARL, PBEAM, PBEAML. A beam whose section changes along it is taken
// with the mean of its section values, weighted with the length that they hold
// for.
#include "updating/structure/cards/bulk_lines.hpp"
#include "updating/structure/readers/deck_builder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tapfit::structure {
namespace {

constexpr const char* kind = "PBAR, PBARL or PBEAM";

void refuse_below_zero(const CardReader& card, double value, const char* name) {
  if (value >= 0.0) return;
  card.fail(fmt::format("{} = {} is below zero", name, value),
            "Give a section value of zero or more.");
}

void check_section(const CardReader& card, const BarProperty& p) {
  refuse_below_zero(card, p.area, "A");
  refuse_below_zero(card, p.I1, "I1");
  refuse_below_zero(card, p.I2, "I2");
  refuse_below_zero(card, p.J, "J");
  refuse_below_zero(card, p.K1, "K1");
  refuse_below_zero(card, p.K2, "K2");
  refuse_below_zero(card, p.nonstructural, "NSM");
  if (p.I12 * p.I12 > p.I1 * p.I2) {
    card.fail(fmt::format("I12 = {} is too large: I1 I2 - I12^2 is below zero",
                          p.I12),
              "Correct I1, I2 or I12.");
  }
}

// Names the property and takes its id.
void head(DeckBuilder& builder, const CardReader& card, BarProperty& p) {
  p.id = card.id(1, "PID");
  builder.define(card, kind, p.id);
  p.where = card.where();
  p.material = card.id(2, "MID");
}

void read_pbar(DeckBuilder& builder, const CardReader& card) {
  BarProperty p;
  head(builder, card, p);
  p.area = card.real_or(3, 0.0, "A");
  p.I1 = card.real_or(4, 0.0, "I1");
  p.I2 = card.real_or(5, 0.0, "I2");
  p.J = card.real_or(6, 0.0, "J");
  p.nonstructural = card.real_or(7, 0.0, "NSM");
  p.K1 = card.real_or(17, 0.0, "K1");
  p.K2 = card.real_or(18, 0.0, "K2");
  p.I12 = card.real_or(19, 0.0, "I12");
  check_section(card, p);
  builder.deck.bar_properties[p.id] = p;
}

std::string section_type(const CardReader& card) {
  const std::string type = upper(card.text(4));
  if (section_dimensions(type) == 0) {
    card.fail(fmt::format("the section type \"{}\" is not supported", type),
              "Give the section's area and moments with a PBAR or PBEAM, or "
              "use one of " +
                  known_sections() + ".");
  }
  return type;
}

BarProperty checked_section(const CardReader& card,
                            const std::string& type,
                            const std::vector<double>& dimensions) {
  std::optional<BarProperty> p = section_of(type, dimensions);
  if (!p) {
    card.fail("the dimensions give no section",
              "They must be above zero and walls must fit inside.");
  }
  return *p;
}

// Of a DBOX what is blank is as thick as another wall.
double dimension(const CardReader& card,
                 const std::string& type,
                 std::size_t field,
                 const std::vector<double>& before) {
  const std::size_t k = before.size();
  if (type == "DBOX" && k >= 4 && card.blank(field)) {
    return before[k < 8 ? 3 : 5];
  }
  return card.real(field, "DIM");
}

void read_pbarl(DeckBuilder& builder, const CardReader& card) {
  const std::string type = section_type(card);
  const std::size_t count = section_dimensions(type);
  std::vector<double> dimensions;
  for (std::size_t i = 0; i < count; ++i) {
    dimensions.push_back(dimension(card, type, 9 + i, dimensions));
  }
  BarProperty p = checked_section(card, type, dimensions);
  // A CBAR's force acts where its section turns.
  p.neutral.setZero();
  head(builder, card, p);
  p.nonstructural = card.real_or(9 + count, 0.0, "NSM");
  check_section(card, p);
  builder.deck.bar_properties[p.id] = p;
}

// A section somewhere along a beam.
struct Station {
  double at = 0.0;  // of its length
  BarProperty section;
};

// Mean over the length of what is linear between stations.
double mean(const std::vector<Station>& stations, double BarProperty::*value) {
  double sum = 0.0;
  for (std::size_t k = 1; k < stations.size(); ++k) {
    sum += 0.5 * (stations[k].at - stations[k - 1].at) *
           (stations[k].section.*value + stations[k - 1].section.*value);
  }
  return sum;
}

bool is_option(const CardReader& card, std::size_t at) {
  const std::string word = upper(card.text(at));
  return word == "YES" || word == "YESA" || word == "NO";
}

constexpr std::array changing = {&BarProperty::area,
                                 &BarProperty::I1,
                                 &BarProperty::I2,
                                 &BarProperty::I12,
                                 &BarProperty::J,
                                 &BarProperty::nonstructural};

// The first station with the mean of all.
BarProperty mean_section(DeckBuilder& builder,
                         const CardReader& card,
                         std::vector<Station> stations) {
  BarProperty p = stations.front().section;
  std::ranges::stable_sort(stations, {}, &Station::at);
  // A last station inside the beam goes on to its end.
  if (stations.back().at < 1.0) {
    stations.push_back(stations.back());
    stations.back().at = 1.0;
  }
  bool changes = false;
  for (double BarProperty::*const value : changing) {
    for (const Station& station : stations) {
      changes = changes || std::abs(station.section.*value - p.*value) >
                               1e-9 * std::abs(p.*value);
    }
  }
  if (!changes) return p;
  for (double BarProperty::*const value : changing) {
    p.*value = mean(stations, value);
  }
  Eigen::Vector2d neutral = Eigen::Vector2d::Zero();
  for (std::size_t k = 1; k < stations.size(); ++k) {
    neutral += 0.5 * (stations[k].at - stations[k - 1].at) *
               (stations[k].section.neutral + stations[k - 1].section.neutral);
  }
  p.neutral = neutral;
  builder.warn(card,
               "the section changes along the beam; the mean of its area and "
               "moments is taken, split the beam where that is too coarse");
  return p;
}

// Of a station at `at`: its place, by default the far end.
double place(const CardReader& card, std::size_t at) {
  const double x = card.real_or(at, 1.0, "X/XB");
  if (!(x >= 0.0 && x <= 1.0)) {
    card.fail(fmt::format("X/XB = {} is not along the beam", x),
              "Give a place between 0 and 1.");
  }
  return x;
}

// Reads the stations of a PBEAM; returns the field behind them.
std::size_t read_stations(const CardReader& card,
                          std::vector<Station>& stations) {
  std::size_t at = 9;
  if (!is_option(card, at)) at += 8;
  while (is_option(card, at)) {
    const BarProperty& first = stations.front().section;
    Station station{place(card, at + 1), first};
    for (std::size_t i = 0; i < changing.size(); ++i) {
      station.section.*changing.at(i) =
          card.real_or(at + 2 + i, first.*changing.at(i), "section");
    }
    check_section(card, station.section);
    stations.push_back(station);
    at += upper(card.text(at)) == "YES" ? 16 : 8;
  }
  return at;
}

// The mean of both ends, of which the second is the first where it is blank.
double of_ends(const CardReader& card,
               std::size_t a,
               std::size_t b,
               const char* meaning) {
  const double at_a = card.real_or(a, 0.0, meaning);
  return 0.5 * (at_a + card.real_or(b, at_a, meaning));
}

void read_pbeam(DeckBuilder& builder, const CardReader& card) {
  BarProperty p;
  head(builder, card, p);
  p.area = card.real(3, "A(A)");
  p.I1 = card.real(4, "I1(A)");
  p.I2 = card.real(5, "I2(A)");
  p.I12 = card.real_or(6, 0.0, "I12(A)");
  p.J = card.real_or(7, 0.0, "J(A)");
  p.nonstructural = card.real_or(8, 0.0, "NSM(A)");
  check_section(card, p);
  std::vector<Station> stations{{0.0, p}};
  const std::size_t shear = read_stations(card, stations);
  p = mean_section(builder, card, stations);
  p.K1 = card.real_or(shear, 1.0, "K1");
  p.K2 = card.real_or(shear + 1, 1.0, "K2");
  p.nonstructural_inertia = of_ends(card, shear + 4, shear + 5, "NSI");
  refuse_below_zero(card, p.nonstructural_inertia, "NSI");
  p.nonstructural_at = {of_ends(card, shear + 8, shear + 10, "M1"),
                        of_ends(card, shear + 9, shear + 11, "M2")};
  p.neutral = {of_ends(card, shear + 12, shear + 14, "N1"),
               of_ends(card, shear + 13, shear + 15, "N2")};
  check_section(card, p);
  builder.deck.bar_properties[p.id] = p;
}

void read_pbeaml(DeckBuilder& builder, const CardReader& card) {
  const std::string type = section_type(card);
  const std::size_t count = section_dimensions(type);
  std::vector<Station> stations;
  std::vector<double> first;
  double mass = 0.0;
  std::size_t at = 9;
  while (stations.empty() || at < card.size()) {
    double x = 0.0;
    if (!stations.empty()) {
      if (!is_option(card, at) && !card.blank(at)) {
        card.fail(fmt::format("field {} (SO) is \"{}\", YES or NO is needed",
                              at + 1,
                              card.text(at)),
                  fmt::format("A section of type {} has {} dimensions and NSM.",
                              type,
                              count));
      }
      x = place(card, at + 1);
      at += 2;
    }
    std::vector<double> dimensions;
    for (std::size_t i = 0; i < count; ++i) {
      dimensions.push_back(stations.empty()
                               ? dimension(card, type, at + i, dimensions)
                               : card.real_or(at + i, first[i], "DIM"));
    }
    if (stations.empty()) first = dimensions;
    mass = card.real_or(at + count, mass, "NSM");
    Station station{x, checked_section(card, type, dimensions)};
    station.section.nonstructural = mass;
    stations.push_back(station);
    at += count + 1;
  }
  BarProperty p = mean_section(builder, card, stations);
  head(builder, card, p);
  p.nonstructural_at = p.neutral;
  check_section(card, p);
  builder.deck.bar_properties[p.id] = p;
}

}  // namespace

CardTable section_cards() {
  return {{"PBAR", read_pbar},
          {"PBARL", read_pbarl},
          {"PBEAM", read_pbeam},
          {"PBEAML", read_pbeaml}};
}

}  // namespace tapfit::structure
