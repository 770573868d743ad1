#include "tui/views/diagnose_view.hpp"

#include "tui/report/report_words.hpp"
#include "tui/screen/layout.hpp"
#include "tui/screen/line_text.hpp"
#include "tui/screen/number.hpp"
#include "tui/screen/text.hpp"
#include "tui/views/diagnose_details.hpp"
#include "tui/views/signature_plot.hpp"
#include "tui/widgets/element_grids.hpp"
#include "tui/widgets/level_marks.hpp"
#include "tui/widgets/plot.hpp"
#include "updating/catalogue/catalogue.hpp"
#include "updating/localisation/signature.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace tapfit::tui {
namespace {

using updating::Candidate;
using updating::Signature;

std::string whole_percent(double share) { return fixed(100.0 * share, 0); }

struct LawWords {
  std::string name;
  std::string size;
  double left = 1.0;  ///< of the misfit
};

/// What each law leaves of z, the one that leaves least first.
std::vector<LawWords> laws_of(const Signature& s) {
  const auto size = [](const char* name, double value) {
    return value_words({name, value}, value);
  };
  std::vector<LawWords> laws{
      {"a pure mass", size("mass_kg", s.mass_kg), s.mass_unexplained},
      {"a spring",
       size("stiffness_n_per_m", s.spring_n_per_m),
       s.spring_unexplained},
      {"a dashpot",
       size("damping_ns_per_m", s.dashpot_ns_per_m),
       s.dashpot_unexplained}};
  if (s.absorber.mass_kg > 0.0) {
    laws.push_back({"an absorber",
                    fmt::format("{} at {} Hz",
                                size("mass_kg", s.absorber.mass_kg),
                                number(s.absorber.frequency_hz, 4)),
                    s.absorber.unexplained});
  }
  std::ranges::stable_sort(laws, {}, &LawWords::left);
  return laws;
}

/// In two lines; where that is too narrow, only the best has its size.
std::vector<std::string> law_lines(const Signature& s, int width) {
  const auto told = [&s](std::size_t sizes) {
    std::string words;
    for (const LawWords& law : laws_of(s)) {
      words += words.empty() ? "" : ", ";
      words += law.name;
      if (sizes > 0) words += fmt::format(" ({})", law.size);
      sizes -= sizes > 0 ? 1 : 0;
      words += words.find(" leaves ") == std::string::npos
                   ? fmt::format(" leaves {} % of it", whole_percent(law.left))
                   : fmt::format(" {} %", whole_percent(law.left));
    }
    return words;
  };
  for (const std::size_t sizes : {4U, 3U, 2U}) {
    std::vector<std::string> lines = wrapped(told(sizes), width);
    if (lines.size() <= 2) return lines;
  }
  return wrapped(told(1), width, 2);
}

/// In two lines: words go before numbers and their unit do.
std::vector<std::string> cursor_lines(const Plot& plot, int width) {
  std::string words = read_out(plot, *plot.cursor);
  if (wrapped(words, width).size() <= 2) return wrapped(words, width);
  const std::string law = " law";
  for (std::size_t at = 0; (at = words.find(law, at)) != std::string::npos;) {
    words.erase(at, law.size());
  }
  return wrapped(words, width, 2);
}

void draw_signature(Screen& screen,
                    const Rect& rect,
                    const DiagnoseInput& input,
                    const DiagnoseState& state,
                    const Candidate& chosen) {
  const auto say = [&](const std::string& words, Colour colour) {
    int y = rect.y + 1;
    for (const std::string& one : wrapped(words, rect.width - 2)) {
      screen.text(rect.x + 1, y++, one, {.colour = colour});
    }
  };
  const std::optional<int> grid = signature_grid(input.bundle, chosen);
  if (!grid) {
    return say(effects::find(chosen.effect).is_mistake()
                   ? "a mistake of the set-up: no force at a grid to plot"
                   : "distributed effect: no plot for a single grid",
               Colour::Default);
  }
  const auto found = input.signatures.find(*grid);
  if (found == input.signatures.end()) {
    return say(fmt::format("signature of grid {} …", *grid), Colour::Grey);
  }
  const Signature& s = *found->second;
  if (!updating::is_telling(s)) {
    return say(fmt::format("grid {} alone explains {} % of the misfit: no plot "
                           "while most of it is elsewhere",
                           s.node,
                           whole_percent(s.explained)),
               Colour::Default);
  }
  const Plot plot = signature_plot(
      s, state.range, state.all_laws, chosen.effect == "absorber");
  const auto parts = split_top(rect, rect.height - 3);
  const Rect& body = parts.first;
  const Rect& text = parts.second;
  draw_plot(screen, body, plot);
  const auto line = [&](int row, const std::string& words) {
    screen.text(text.x + 1, text.y + row, words, {}, text.width - 1);
  };
  line(0,
       fmt::format(
           "grid {} alone explains {} % of the misfit{}",
           s.node,
           whole_percent(s.explained),
           input.diagnosis.ladder.size() > 1 ? ", other effects along" : ""));
  std::vector<std::string> lines = law_lines(s, text.width - 1);
  if (plot.cursor) {
    lines = cursor_lines(plot, text.width - 1);
  }
  for (std::size_t i = 0; i < lines.size(); ++i) {
    line(static_cast<int>(i) + 1, lines[i]);
  }
}

void draw_place(Screen& screen,
                const Rect& rect,
                const DiagnoseInput& input,
                const DiagnoseState& state,
                const std::vector<int>& grids) {
  if (input.wire == nullptr) return;
  Scene scene;
  const bool few = grids.size() <= 4;
  for (const int node : grids) {
    scene.marks.push_back({node,
                           U'●',
                           {.colour = Colour::Red, .bold = true},
                           few ? fmt::format("{}", node) : std::string()});
  }
  scene.highlighted = grids;
  draw_wireframe(screen, rect, *input.wire, scene, state.pose);
}

/// Grids by how well each alone explains what is missing: those that come
/// near the best one.
void draw_map(Screen& screen,
              const Rect& rect,
              const DiagnoseInput& input,
              const DiagnoseState& state) {
  if (input.wire == nullptr) return;
  if (input.map == nullptr || input.map->empty()) {
    screen.text(rect.x + 1,
                rect.y + 1,
                "signature of every grid …",
                {.colour = Colour::Grey});
    return;
  }
  const std::vector<updating::GridShare>& map = *input.map;
  const double best = std::max(map.front().explained, 1e-9);
  Scene scene;
  for (std::size_t i = map.size(); i-- > 0;) {
    const double share = map[i].explained / best;
    if (share < 0.5) continue;
    const LevelMark& level = level_marks[share > 0.95   ? 3
                                         : share > 0.85 ? 2
                                         : share > 0.7  ? 1
                                                        : 0];
    scene.marks.push_back(
        {map[i].node,
         level.glyph,
         {.colour = level.colour, .bold = i == 0},
         i == 0 ? fmt::format("{}: {}", map[i].node, percent(map[i].explained))
                : std::string()});
  }
  const auto [body, lines] = split_top(rect, rect.height - 2);
  draw_wireframe(screen, body, *input.wire, scene, state.pose);
  std::vector<std::string> shares;
  for (std::size_t i = 0; i < std::min<std::size_t>(map.size(), 3); ++i) {
    shares.push_back(
        fmt::format("{} {}", map[i].node, percent(map[i].explained)));
  }
  screen.text(
      lines.x + 1,
      lines.y,
      fitting({fmt::format("alone explain: {}", fmt::join(shares, ", ")),
               listed("alone: ", shares, ", ", lines.width - 1)},
              lines.width - 1),
      {.colour = Colour::Grey},
      lines.width - 1);
  int x = lines.x + 1;
  for (const auto& [level, what] :
       {std::pair{3U, "95"}, {2U, "85"}, {1U, "70"}, {0U, "50 % of best"}}) {
    const LevelMark& mark = level_marks[level];
    screen.put(x, lines.y + 1, mark.glyph, {.colour = mark.colour});
    x = screen.text(x + 2, lines.y + 1, what, {.colour = Colour::Grey}) + 1;
  }
}

/// Lines below each other from row y; returns the row after them.
int write(Screen& screen,
          int y,
          const std::vector<std::string>& lines,
          Colour colour) {
  for (const std::string& line : lines) {
    screen.text(1, y++, line, {.colour = colour}, screen.width() - 2);
  }
  return y;
}

/// How large the chosen one is, and what else it could be.
int write_chosen(Screen& screen,
                 int y,
                 const updating::Diagnosis& d,
                 const Candidate& chosen) {
  const int width = screen.width() - 2;
  y = write(screen, y, wrapped(all_sizes(chosen), width, 2), Colour::Default);
  if (d.verdict.empty()) return y;
  // The narrow table has no column for it.
  const bool tried = chosen.held_out_error > 0.0 && !is_wide(screen.width());
  const std::string error =
      tried ? fmt::format("hold-out error {}; ", left_out(chosen)) : "";
  // A long list of look-alikes may be cut off, what to do about it not.
  const std::string words = next_step(d, chosen) + error + look_alikes(chosen);
  const bool unsure = !chosen.indistinguishable_from.empty();
  return write(screen,
               y,
               wrapped(words, width, 3),
               unsure ? Colour::Yellow : Colour::Default);
}

/// The verdict and the errors, which get a line of their own beside a long
/// list of kinds.
std::vector<std::string> verdict_lines(const updating::Diagnosis& d,
                                       Standing standing,
                                       std::size_t tagged,
                                       int width) {
  if (standing == Standing::Preliminary) {
    return {fmt::format("{}   {} tried, the best leaves {}",
                        verdict_words(d),
                        d.candidates.size(),
                        percent(d.error_best))};
  }
  std::string errors = fmt::format("error {} → {}, floor {}",
                                   percent(d.error_base),
                                   percent(d.error_best),
                                   percent(d.floor));
  if (tagged > 0) errors += fmt::format("   {} tagged", tagged);
  const std::string verdict = verdict_words(d);
  const std::string both = verdict + "   " + errors;
  if (text_width(both) <= width) return {both};
  return {verdict, errors};
}

/// What stands in the way or, where nothing does, how it was compared. All of
/// it is in the details.
std::string note_line(const updating::Diagnosis& d,
                      Standing standing,
                      int width) {
  if (standing == Standing::Outdated) return "outdated, diagnosing again …";
  if (standing == Standing::Preliminary) {
    return "preliminary: of each kind what was fitted first; a adds one";
  }
  const bool warned = !d.warnings.empty();
  std::string note = warned ? "! " + d.warnings[0] : contour_words(d.contour);
  const std::string more =
      d.warnings.size() > 1
          ? fmt::format("  (1 of {} notes, i: all)", d.warnings.size())
          : "  (i: all)";
  if (text_width(note) <= width && d.warnings.size() < 2) return note;
  return clipped(note, width - text_width(more)) + more;
}

/// In place of table and plots, from row `top` on, scrolled down so far.
void draw_lines(Screen& screen,
                const std::vector<std::string>& lines,
                int top,
                int first) {
  const int rows = screen.height() - top;
  const int count = static_cast<int>(lines.size());
  first = std::clamp(first, 0, std::max(count - rows, 0));
  for (int i = 0; i < std::min(rows, count - first); ++i) {
    screen.text(1, top + i, lines[static_cast<std::size_t>(first + i)]);
  }
  const int right = screen.width() - 1;
  if (first > 0) screen.put(right, top, U'↑');
  if (first + rows < count) screen.put(right, screen.height() - 1, U'↓');
}

}  // namespace

std::vector<int> grids_of(const acquisition::TestBundle& bundle,
                          const updating::Where& where,
                          const structure::Deck* deck) {
  std::vector<int> once;
  const auto add = [&once](int grid) {
    if (std::find(once.begin(), once.end(), grid) == once.end()) {
      once.push_back(grid);
    }
  };
  const auto is_meant = [&](const acquisition::Placement& sensor) {
    return sensor.channel < bundle.channels.size() &&
           std::find(where.channels.begin(),
                     where.channels.end(),
                     bundle.channels[sensor.channel].name) !=
               where.channels.end();
  };
  if (where.node != 0) add(where.node);
  for (const int node : where.nodes) add(node);
  for (const acquisition::Run& run : bundle.runs) {
    for (const acquisition::Placement& sensor : run.sensors) {
      if (is_meant(sensor)) add(sensor.dof.node);
    }
  }
  if (deck == nullptr) return once;
  for (const int node : element_grids(*deck, where.elements)) add(node);
  return once;
}

std::optional<int> signature_grid(const acquisition::TestBundle& bundle,
                                  const Candidate& candidate) {
  if (!candidate.where.elements.empty()) return std::nullopt;
  if (effects::find(candidate.effect).is_mistake()) return std::nullopt;
  const std::vector<int> grids = grids_of(bundle, candidate.where);
  if (grids.size() != 1) return std::nullopt;
  return grids.front();
}

Screen diagnose_view(const DiagnoseInput& input,
                     const DiagnoseState& state,
                     const Canvas& canvas) {
  Screen screen(canvas);
  const updating::Diagnosis& d = input.diagnosis;
  const std::size_t tagged = tagged_of(d, state.tagged).size();
  const int room = canvas.width - 2;
  int top = 0;
  const bool outdated = input.standing == Standing::Outdated;
  for (const std::string& line :
       verdict_lines(d, input.standing, tagged, room)) {
    screen.text(1, top++, line, {.bold = true}, room);
  }
  const bool warned = input.standing != Standing::Final || !d.warnings.empty();
  screen.text(1,
              top++,
              note_line(d, input.standing, room),
              {.colour = warned ? Colour::Yellow : Colour::Grey});
  if (state.firmness) {
    draw_lines(screen, firmness_lines(d, room), top + 1, *state.firmness);
    return screen;
  }
  if (d.candidates.empty()) {
    int y = write(screen,
                  top + 1,
                  {"No candidate: nothing in the catalogue fits.", ""},
                  Colour::Default);
    for (const std::string& warning : d.warnings) {
      y = write(screen, y, wrapped("! " + warning, canvas.width - 2), {});
    }
    return screen;
  }
  Table table = candidate_table(d, state.tagged, canvas.width, canvas.ascii);
  if (outdated) {
    for (Row& row : table.rows) row.style.colour = Colour::Grey;
  }
  const Candidate& chosen = d.candidates[settled(table, state.list)];
  if (none_shown(table, state.list)) {
    draw_table(screen, {0, top, canvas.width, 4}, table, state.list, true);
    return screen;
  }
  if (state.details) {
    draw_lines(screen, details_of(d, chosen, room), top + 1, *state.details);
    return screen;
  }
  const Rect body{0, top, canvas.width, canvas.height - top};
  const int rows = std::clamp(static_cast<int>(d.candidates.size()) + 1,
                              4,
                              std::max(body.height / 3, 4));
  const auto [list, rest] = split_top(body, rows);
  draw_table(screen, list, table, state.list, true);
  const int below = write_chosen(screen, rest.y, d, chosen);
  if (outdated) return screen;
  const Rect lower{0, below, canvas.width, canvas.height - below};
  const std::vector<int> grids =
      grids_of(input.bundle, chosen.where, input.deck);
  const auto [left, right] = split_left(lower, canvas.width * 5 / 8);
  draw_signature(screen, left, input, state, chosen);
  if (state.map) {
    draw_map(screen, right, input, state);
  } else {
    draw_place(screen, right, input, state, grids);
  }
  return screen;
}

}  // namespace tapfit::tui
