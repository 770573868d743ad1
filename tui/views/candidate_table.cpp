#include "tui/views/candidate_table.hpp"

#include "tui/screen/line_text.hpp"
#include "tui/screen/number.hpp"
#include "tui/screen/text.hpp"
#include "tui/widgets/bars.hpp"

#include <algorithm>

namespace tapfit::tui {
namespace {

using updating::Candidate;

/// The first parameter as fully as the room allows; a number is never cut.
std::string first_size(const Candidate& candidate, bool named, int room) {
  if (candidate.parameters.empty()) return "–";
  const updating::Estimate& p = candidate.parameters[0];
  if (named && text_width(describe(p)) <= room) return describe(p);
  const std::string whole = size_words(p);
  if (is_open(p) || text_width(whole) <= room) return whole;
  return number(p.value, 3) + " " + split_unit(p.name).unit;
}

bool is_in(const std::vector<updating::EffectRef>& tagged, const Candidate& c) {
  return std::ranges::find(tagged, updating::EffectRef{c.effect, c.where}) !=
         tagged.end();
}

/// Which rung of the verdict it is; empty for what was tried besides.
std::string rung_of(const updating::Diagnosis& d, const Candidate& c) {
  for (std::size_t i = 0; i < d.ladder.size(); ++i) {
    const updating::Rung& rung = d.ladder[i];
    if (updating::leading_kind(rung) == c.effect && rung.where == c.where) {
      return std::to_string(i + 1);
    }
  }
  return {};
}

/// What stands in brackets is left out where it does not fit.
std::string brief_place(const updating::Location& where, int width) {
  const std::string whole = place(where);
  return clipped(fitting({whole, whole.substr(0, whole.find(" ("))}, width),
                 width);
}

/// Of different effects sizes do not compare.
const Column size_column{"size", false, false, ""};

std::size_t column_of(const Table& table, const char* title) {
  const auto at = std::ranges::find(table.columns, title, &Column::title);
  return static_cast<std::size_t>(at - table.columns.begin());
}

/// What the columns before it leave of the screen.
int room_for_size(const Table& table, int width, bool ascii) {
  int used = 2;
  for (std::size_t c = 0; c < column_of(table, "size"); ++c) {
    int widest = text_width(table.columns[c].title);
    for (const Row& row : table.rows) {
      widest = std::max(widest, text_width(row.cells[c]));
    }
    used += widest + 2;
  }
  return width - used - (ascii ? 1 : 0);  // there, a "±" is two wide
}

/// How probable it is, as soon as there is a verdict.
std::vector<std::string> probability_cells(const updating::Diagnosis& d,
                                           const Candidate& c,
                                           int bars,
                                           bool ascii) {
  if (d.verdict.empty()) return {"–", ""};
  return {probability(c.probability), bar(c.probability, bars, ascii)};
}

Table wide_table(const updating::Diagnosis& d, bool ascii) {
  Table table{{{"rung", true},
               {"probability", true},
               {"", false, true},
               {"effect"},
               {"where"},
               {"error", true},
               {"hold-out error", true},
               size_column},
              {}};
  for (const Candidate& c : d.candidates) {
    const auto probable = probability_cells(d, c, 8, ascii);
    table.rows.push_back({{rung_of(d, c),
                           probable[0],
                           probable[1],
                           c.effect,
                           brief_place(c.where, 24),
                           percent(c.error),
                           left_out(c),
                           ""},
                          {}});
  }
  return table;
}

Table narrow_table(const updating::Diagnosis& d, bool ascii) {
  Table table{{{"#", true, false, "rung"},
               {"prob.", true, false, "probability"},
               {"", false, true},
               {"effect"},
               {"where"},
               {"error", true},
               size_column,
               {"hold-out error", true}},
              {}};
  for (const Candidate& c : d.candidates) {
    const auto probable = probability_cells(d, c, 4, ascii);
    table.rows.push_back({{rung_of(d, c),
                           probable[0],
                           probable[1],
                           c.effect,
                           brief_place(c.where, 13),
                           percent(c.error),
                           "",
                           left_out(c)},
                          {}});
  }
  return table;
}

/// The probability stands beside them in numbers, the sizes nowhere else.
void drop_bars(Table& table) {
  for (std::size_t c = table.columns.size(); c-- > 0;) {
    if (!table.columns[c].bars) continue;
    const auto at = static_cast<std::ptrdiff_t>(c);
    table.columns.erase(table.columns.begin() + at);
    for (Row& row : table.rows) row.cells.erase(row.cells.begin() + at);
  }
}

}  // namespace

std::string left_out(const Candidate& c) {
  return c.held_out_error > 0.0 ? percent(c.held_out_error) : "–";
}

bool is_wide(int width) { return width >= 110; }

std::vector<updating::EffectRef> tagged_of(
    const updating::Diagnosis& d,
    const std::vector<updating::EffectRef>& tagged) {
  std::vector<updating::EffectRef> found;
  for (const Candidate& c : d.candidates) {
    if (is_in(tagged, c))
      found.push_back({c.effect, c.where, c.place_sd, c.sizes});
  }
  return found;
}

Table candidate_table(const updating::Diagnosis& d,
                      const std::vector<updating::EffectRef>& tagged,
                      int width,
                      bool ascii) {
  Table table = is_wide(width) ? wide_table(d, ascii) : narrow_table(d, ascii);
  table.sortable = true;
  for (std::size_t i = 0; i < d.candidates.size(); ++i) {
    if (is_in(tagged, d.candidates[i])) table.rows[i].cells[0].insert(0, "*");
  }
  int room = room_for_size(table, width, ascii);
  const bool cramped = std::ranges::any_of(d.candidates, [&](const auto& c) {
    return !c.parameters.empty() &&
           text_width(size_words(c.parameters[0])) > room;
  });
  if (cramped) {
    drop_bars(table);
    room = room_for_size(table, width, ascii);
  }
  const std::size_t size = column_of(table, "size");
  const std::size_t where = column_of(table, "where");
  for (std::size_t i = 0; i < d.candidates.size(); ++i) {
    Row& row = table.rows[i];
    row.cells[size] = first_size(d.candidates[i], is_wide(width), room);
    row.keys = row.cells;
    row.keys[where] = place(d.candidates[i].where);
    if (!d.candidates[i].indistinguishable_from.empty()) {
      row.style.colour = Colour::Yellow;
    }
  }
  return table;
}

}  // namespace tapfit::tui
