#include "tui/views/diagnose_panels.hpp"

#include "tui/report/report_words.hpp"
#include "tui/screen/layout.hpp"
#include "tui/screen/line_text.hpp"
#include "tui/screen/number.hpp"
#include "tui/screen/text.hpp"
#include "tui/views/frf_curves.hpp"
#include "tui/widgets/element_grids.hpp"
#include "tui/widgets/level_marks.hpp"
#include "tui/widgets/plot.hpp"
#include "tui/widgets/signature_plot.hpp"
#include "updating/catalogue/catalogue.hpp"
#include "updating/localisation/signature.hpp"
#include "updating/localisation/signature_laws.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <string>

namespace tapfit::tui {
namespace {

using updating::Candidate;
using updating::Signature;

std::string whole_percent(double share) { return fixed(100.0 * share, 0); }

/// What each law leaves of z, the one that leaves least first.
std::vector<updating::SignatureLaw> laws_of(const Signature& s) {
  std::vector<updating::SignatureLaw> laws = updating::signature_laws(s);
  std::ranges::stable_sort(laws, {}, &updating::SignatureLaw::unexplained);
  return laws;
}

/// What laws leave; sizes stand above, as they were fitted to all data.
std::vector<std::string> law_lines(const Signature& s, int width) {
  std::string words;
  for (const updating::SignatureLaw& law : laws_of(s)) {
    const std::string left = whole_percent(law.unexplained);
    words += words.empty()
                 ? fmt::format("{} leaves {} % of it", law_name(law), left)
                 : fmt::format(", {} {} %", law_name(law), left);
  }
  return wrapped(words, width, 2);
}

/// Of that FRF, the errors without and with the effect.
std::string most_shown(const signal::Frf& frf,
                       const updating::EffectEvidence& evidence,
                       int width) {
  const std::string drop = fmt::format("{} → {}",
                                       percent(evidence.frf_error_without),
                                       percent(evidence.frf_error_with));
  const std::string frf_name = signal::name(frf);
  return fitting({fmt::format("{}, where it shows most: {}", frf_name, drop),
                  fmt::format("{}, most: {}", frf_name, drop),
                  fmt::format("{}: {}", frf_name, drop)},
                 width);
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

}  // namespace

std::string missing_words(const updating::EffectRef& missing,
                          Standing standing) {
  return fmt::format(
      "{} {}; j k choose another",
      updating::effect_text(missing.effect, missing.where),
      standing == Standing::Preliminary
          ? "is not tried yet: the cursor goes back to it once it is"
          : "is not in this list");
}

std::vector<int> grids_of(const acquisition::TestBundle& bundle,
                          const updating::Location& where,
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
  if (candidate.effect == updating::nonlinearity) return std::nullopt;
  if (effects::find(candidate.effect).is_mistake()) return std::nullopt;
  const std::vector<int> grids = grids_of(bundle, candidate.where);
  if (grids.size() != 1) return std::nullopt;
  return grids.front();
}

bool has_signature(
    const acquisition::TestBundle& bundle,
    const std::map<int, std::shared_ptr<const updating::Signature>>& signatures,
    const Candidate& candidate) {
  const std::optional<int> grid = signature_grid(bundle, candidate);
  if (!grid) return false;
  const auto found = signatures.find(*grid);
  return found == signatures.end() || updating::is_significant(*found->second);
}

void draw_evidence(Screen& screen,
                   const Rect& rect,
                   const EvidenceInput& input,
                   const PlotRange& range) {
  const std::vector<signal::Frf>& frfs = input.frfs.frfs;
  const int width = rect.width - 1;
  const updating::EffectEvidence* found = input.evidence;
  std::vector<std::string> lines;
  Rect body = rect;
  if (found == nullptr) {
    lines = {"FRFs with and without it …"};
  } else {
    lines = wrapped(drop_words(found->error_without, found->error_with) +
                        (frfs.empty() ? "" : ", of all FRFs") +
                        "; all else fitted anew",
                    width,
                    2);
  }
  if (found != nullptr && found->frf && *found->frf < frfs.size()) {
    Plot plot = evidence_plot(input.frfs, *found, range);
    constexpr int roomy = 70;  // for the FRF's name beside those of its curves
    if (rect.width < roomy) plot.title.clear();
    lines.insert(lines.begin(),
                 plot.cursor ? read_out(plot, *plot.cursor)
                             : most_shown(frfs[*found->frf], *found, width));
    const int rows = static_cast<int>(lines.size()) + !input.note.empty();
    const auto parts = split_top(rect, rect.height - rows);
    draw_plot(screen, parts.first, plot);
    body = parts.second;
  }
  if (!input.note.empty()) lines.push_back(input.note);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    screen.text(body.x + 1, body.y + static_cast<int>(i), lines[i], {}, width);
  }
}

void draw_signature(Screen& screen,
                    const Rect& rect,
                    const DiagnoseInput& input,
                    const DiagnoseState& state,
                    const Candidate& chosen) {
  const int grid = *signature_grid(input.bundle, chosen);
  const auto found = input.signatures.find(grid);
  if (found == input.signatures.end()) {
    screen.text(rect.x + 1,
                rect.y + 1,
                fmt::format("signature of grid {} …", grid),
                {.colour = Colour::Grey});
    return;
  }
  const Signature& s = *found->second;
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
                const Wireframe* wire,
                const Pose& pose,
                const std::vector<int>& grids) {
  if (wire == nullptr) return;
  Scene scene;
  const bool few = grids.size() <= 4;
  for (const int node : grids) {
    scene.marks.push_back({node,
                           U'●',
                           {.colour = Colour::Red, .bold = true},
                           few ? fmt::format("{}", node) : std::string()});
  }
  scene.highlighted = grids;
  draw_wireframe(screen, rect, *wire, scene, pose);
}

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
  scene.value_name = "explains alone [%]";
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
                : std::string(),
         100.0 * map[i].explained});
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

}  // namespace tapfit::tui
